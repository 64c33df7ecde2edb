load 'book/plots/style.gp'
set logscale xy
set xrange [70:150000]
set xlabel 'discs'
set ylabel 'a step, ms'
set format xy '%g'
set key top left
data = 'book/data/performance-growth-time.csv'
plot '< grep ^1 '.data using 1:2 with linespoints title 'this engine', \
     '' using 1:3 with linespoints title 'Box2D 3.2', \
     '' using 1:4 with linespoints title 'Box2D 3.2, not wide', \
     0.0005 * x with lines dt 3 title 'in proportion'
