load 'book/plots/style.gp'
set xlabel 'boxes in the stack'
set ylabel 'deepest overlap, mm'
set key top left
set logscale y
plot 'book/data/impulses-stack.csv' skip 3 using 1:2 with linespoints title '1 pass', \
     '' skip 3 using 1:3 with linespoints title '8 passes', '' skip 3 using 1:4 with linespoints title '64 passes', \
     5 with lines lc rgb faint title 'slop'
