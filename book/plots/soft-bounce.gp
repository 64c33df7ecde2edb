load 'book/plots/style.gp'
set xlabel 'time, s'
set ylabel 'energy, of that at the start'
set key center right
plot 'book/data/soft-bounce.csv' skip 3 using 1:2 with lines title 'resolver with friction', \
     '' skip 3 using 1:3 with lines title 'sequential', '' skip 3 using 1:4 with lines title 'soft'
