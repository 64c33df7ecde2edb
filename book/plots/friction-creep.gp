load 'book/plots/style.gp'
set xlabel 'steepness: tan(angle) / friction'
set ylabel 'crept in 10 s, m'
set key top left
plot 'book/data/friction-creep.csv' skip 3 using 1:2 with linespoints title 'resolver with friction', \
     '' skip 3 using 1:3 with lines lc rgb faint dt 2 title 'half a step late'
