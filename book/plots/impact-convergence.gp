load 'book/plots/style.gp'
set xlabel 'distances asked for'
set ylabel 'gap above the goal, m'
set logscale y
set format y '%g'
set key top right
plot 'book/data/impact-convergence.csv' skip 3 using 1:2 with linespoints title 'plain', \
     '' skip 3 using 1:3 with linespoints title 'along the normal', \
     '' skip 3 using 1:4 with linespoints title 'and discs', \
     '' skip 3 using 1:5 with linespoints title 'and the curve'
