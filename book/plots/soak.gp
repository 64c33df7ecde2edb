load 'book/plots/style.gp'
set logscale y
set xlabel 'million steps'
set ylabel 'J, m'
set yrange [1e-3:1e6]
set format y '%g'
set key top right
plot 'book/data/soak.csv' using ($1/1e6):5 with lines title 'kinetic energy (J)', \
     'book/data/soak.csv' using ($1/1e6):7 with lines title 'deepest overlap (m)', \
     'book/data/soak.csv' using ($1/1e6):8 with lines title 'deepest overlap of a step, on average (m)'
