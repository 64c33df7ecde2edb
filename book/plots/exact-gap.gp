load 'book/plots/style.gp'
set logscale xy
set xlabel 'load, in masses of a link'
set ylabel 'widest gap, m'
set xrange [0.7:14000]
set format y '%g'
set key top left
plot 'book/data/exact-gap.csv' skip 3 using 1:2 with linespoints title 'one by one', \
     '' skip 3 using 1:3 with linespoints title 'all at once'
