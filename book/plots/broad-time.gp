load 'book/plots/style.gp'
set logscale xy
set linetype 7 lc rgb good lw 2 pt 6 ps 0.9 dt 2
set linetype cycle 7
set xrange [7:200000]
set yrange [2:60000]
set xlabel 'boxes'
set ylabel 'time per box, in box tests of brute force'
set format xy '%.0f'
set key top left
world = 'uniform'
plot '< grep ^'.world.', book/data/broad-time.csv' using 2:4 with linespoints title 'brute force', \
     '' using 2:6 with linespoints title 'quad tree', \
     '' using 2:8 with linespoints title 'grid', \
     '' using 2:10 with linespoints title 'spatial hash', \
     '' using 2:12 with linespoints title 'sweep and prune', \
     '' using 2:14 with linespoints title 'tree of boxes', \
     '' using 2:16 with linespoints title 'dynamic tree'
