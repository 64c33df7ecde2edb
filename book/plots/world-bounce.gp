load 'book/plots/style.gp'
set xlabel 'step, s'
set ylabel 'worst relative error of the apex'
set logscale xy
set format x '%g'
set format y '%g'
set key top left
plot 'book/data/world-bounce.csv' skip 3 using 2:3 with linespoints title 'measured', \
     3*x with lines lc rgb faint title 'slope 1'
