load 'book/plots/style.gp'
set xlabel 'passes'
set ylabel 'relative error of the impulses'
set logscale y
set format y '10^{%T}'
set terminal svg size 640,plot_height font 'sans-serif,14' linewidth 1.3 enhanced background '#ffffff'
set key top right
plot 'book/data/sequential-convergence.csv' skip 3 using 1:2 with linespoints title 'from nothing', \
     '' skip 3 using 1:3 with linespoints title 'from the last step', '' skip 3 using 1:4 with lines lc rgb faint dt 2 title 'predicted slope'
