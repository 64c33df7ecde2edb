load 'book/plots/style.gp'
set xlabel 'boxes in the stack'
set ylabel 'speed of the fastest box, mm/s'
set key top left
set logscale y
set format y '%g'
set yrange [0.001:1000000]
plot 'book/data/impulses-stack.csv' skip 3 using 1:5 with linespoints title '1 pass', \
     '' skip 3 using 1:6 with linespoints title '8 passes', '' skip 3 using 1:7 with linespoints title '64 passes'
