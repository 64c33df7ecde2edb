# integrators-energy: the largest error of the energy in each turn of an orbit.
load 'book/plots/style.gp'
file = 'book/data/integrators-energy.csv'
set logscale xy
set termoption enhanced
set format y '10^{%T}'
set xlabel 'turn'
set ylabel 'relative error of the energy'
set xrange [1:1000]
set yrange [1e-6:10]
methods = 'explicit-euler symplectic-euler verlet implicit-midpoint rk4'
styles = '5 2 3 4 1'
sel(m) = sprintf("< awk -F, '$1==\"%s\"' %s", m, file)
set key bottom right font ',12' samplen 1.5
plot for [i=1:5] sel(word(methods, i)) using 2:3 with linespoints lt int(word(styles, i)) title word(methods, i)
