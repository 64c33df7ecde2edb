load 'book/plots/style.gp'
set xlabel 'time, s'
set ylabel 'speed, m/s'
set yrange [0:4.2]
set key bottom right
plot 'book/data/friction-roll.csv' skip 3 using 1:2 with lines title 'speed of the centre', \
     '' skip 3 using 1:3 with lines title 'speed of the rim', 4*2/3. with lines lc rgb faint dt 2 title 'two thirds'
