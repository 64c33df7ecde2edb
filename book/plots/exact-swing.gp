load 'book/plots/style.gp'
set xlabel 'time, s'
set ylabel 'energy, % of level'
set xrange [0:10]
set yrange [0:200]
set key top right
set datafile missing ''
plot 'book/data/exact-swing.csv' skip 3 using 1:2 with lines title 'one by one', \
     '' skip 3 using 1:3 with lines title 'rigidly, 400 passes', \
     '' skip 3 using 1:4 with lines title 'all at once'
