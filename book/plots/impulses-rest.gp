load 'book/plots/style.gp'
set xlabel 'time, s'
set ylabel 'height of the lowest corner, mm'
set key top right
plot 'book/data/impulses-rest.csv' skip 3 using 1:2 with lines title 'every contact bounces', \
     '' skip 3 using 1:3 with lines title 'slow contacts rest'
