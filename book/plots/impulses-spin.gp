load 'book/plots/style.gp'
set xlabel 'passes'
set ylabel 'spin, rad/s'
set xrange [0.5:8.5]
set key top right
plot 'book/data/impulses-spin.csv' skip 3 using 1:2 with linespoints title 'one point after the other', \
     '' skip 3 using 1:3 with linespoints title 'both together'
