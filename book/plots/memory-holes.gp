load 'book/plots/style.gp'
set xlabel 'step'
set ylabel 'cells'
set yrange [0:]
set key top right
plot 'book/data/memory-holes.csv' using 1:2 skip 1 with lines title 'free in all', \
     '' using 1:3 skip 1 with lines title 'longest hole'
