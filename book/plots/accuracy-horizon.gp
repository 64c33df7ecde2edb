# accuracy-horizon: how the error of a double pendulum grows.
load 'book/plots/style.gp'
set logscale y
set termoption enhanced
set format y '10^{%T}'
set xlabel 'time, s'
set ylabel 'error of a place (m)'
set yrange [1e-7:5]
set key bottom right
set datafile missing ''
plot 'book/data/accuracy-horizon.csv' skip 3 using 1:2 with lines title '1 substep in a frame', \
     '' skip 3 using 1:3 with lines title '4 substeps', '' skip 3 using 1:4 with lines title '16 substeps'
