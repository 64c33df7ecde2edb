load 'book/plots/style.gp'
set logscale xy
set format y '10^{%T}'
set format y '%.0e'
set format x '%.0e'
set xrange [1:1e12]
set yrange [1e-16:1e6]
set xlabel 'distance from the origin (m)'
set ylabel 'error of the place after 5 s (m)'
set key top left
plot 'book/data/world-far.csv' using 1:3 skip 1 with linespoints lt 5 title 'floats', \
     '' using 1:2 skip 1 with lines dt 3 lc rgb bad title 'gap between floats', \
     'book/data/world-far-double.csv' using 1:3 skip 1 with linespoints lt 1 title 'doubles', \
     '' using 1:2 skip 1 with lines dt 3 lc rgb body title 'gap between doubles'
