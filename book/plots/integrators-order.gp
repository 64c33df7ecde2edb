# integrators-order: error against cost, all methods, spring (left) and orbit (right).
plot_height = 420
load 'book/plots/style.gp'
file = 'book/data/integrators-order.csv'
set multiplot layout 1,2
set logscale xy
set format x '10^{%T}'
set format y '10^{%T}'
set termoption enhanced
set xlabel 'evaluations of the forces'
set ylabel 'error at the end (m)'
set yrange [5e-8:3]
set xrange [6:4e5]
methods = 'explicit-euler symplectic-euler verlet rk4 implicit-midpoint'
styles = '5 2 3 1 4'
sel(p, m) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, m, file)
set key top right font ',10' samplen 1 spacing 0.9
set yrange [5e-8:30]
set title 'spring' textcolor rgb text
plot for [i=1:5] sel('spring', word(methods, i)) using 5:6 with linespoints lt int(word(styles, i)) title word(methods, i)
unset ylabel
set format y ''
set title 'orbit' textcolor rgb text
plot for [i=1:5] sel('orbit', word(methods, i)) using 5:6 with linespoints lt int(word(styles, i)) notitle
unset multiplot
