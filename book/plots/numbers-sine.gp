load 'book/plots/style.gp'
set logscale xy
set format y '%.0e'
set xlabel 'largest angle (rad)'
set ylabel 'largest error of the sine'
set key top left
set format x '%g'
plot 'book/data/numbers-sine.csv' using 1:2 skip 1 with linespoints title 'reduced in floats', \
     '' using 1:3 skip 1 with linespoints title 'wfSin', \
     2.0**-25 with lines dt 3 lc rgb line title 'half the gap just below 1'
