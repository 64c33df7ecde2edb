load 'book/plots/style.gp'
set logscale xy
set linetype 7 lc rgb good lw 2 pt 6 ps 0.9 dt 2
set linetype cycle 7
set xrange [8:7000]
set xlabel 'boxes'
set ylabel 'box tests'
set format y '%.0f'
set key top left
set yrange [1:1e10]
plot '< grep ^uniform book/data/broad-pairs.csv' using 2:5 with linespoints title 'brute force', \
     '' using 2:7 with linespoints title 'quad tree, climbing', \
     '' using 2:9 with linespoints title 'quad tree, descending', \
     '' using 2:15 with linespoints title 'sweep and prune', \
     '' using 2:17 with linespoints title 'tree of boxes', \
     '' using 2:19 with linespoints title 'dynamic tree', \
     '' using 2:11 with linespoints title 'grid', \
     '' using 2:3 with lines lc rgb faint title 'pairs that there are'
