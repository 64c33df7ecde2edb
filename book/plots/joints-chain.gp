load 'book/plots/style.gp'
set logscale xy
set xlabel 'substeps'
set ylabel 'stretch, share of the length'
set xrange [0.8:80]
set yrange [1e-7:20]
set format y '%g'
set key top right
plot for [i=2:5] 'book/data/joints-chain.csv' skip 3 using 1:i with linespoints title sprintf("load of %g kg", 10**(i-2)), \
     0.3/x**2 with lines dt 2 lc rgb '#888888' title 'order 2'
