load 'book/plots/style.gp'
set xlabel 'time, s'
set ylabel 'place of the block, m'
set key bottom right
plot 'book/data/friction-violin.csv' skip 3 using 1:2 with lines title 'block', \
     '' skip 3 using 1:3 with lines lc rgb faint dt 2 title 'sticks from', '' skip 3 using 1:4 with lines lc rgb faint dt 2 title 'slips at'
