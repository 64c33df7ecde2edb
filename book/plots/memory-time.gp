load 'book/plots/style.gp'
set logscale xy 2
set logscale y 10
set xlabel 'bytes per request'
set ylabel 'nanoseconds per request'
set key top left
plot 'book/data/memory-time.csv' using 1:2 skip 1 with linespoints title 'malloc and free', \
     '' using 1:3 skip 1 with linespoints title 'pool'
