# accuracy-integrators: error at the end against questions to the forces; failures at the top edge.
plot_height = 620
load 'book/plots/style.gp'
file = 'book/data/accuracy-integrators.csv'
set multiplot layout 2,3 margins 0.13,0.985,0.16,0.94 spacing 0.03,0.11
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set format y '10^{%T}'
set xrange [3:8e4]
set yrange [1e-8:20]
set tics font ',11'

methods = 'explicit-euler symplectic-euler verlet rk4 implicit-midpoint'
styles = '5 2 3 1 4'
sel(p, m) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, m, file)
problems = '"spring" "orbit" "pendulum" "projectile" "stiff spring" "buoyancy"'
unset key
do for [k=1:6] {
  p = word(problems, k)
  set title p textcolor rgb text offset 0,-0.7
  if (k == 1 || k == 4) { set ylabel 'error at the end (m)'; set format y '10^{%T}' } else { unset ylabel; set format y '' }
  if (k > 3) { set xlabel 'questions to the forces' } else { unset xlabel }
  plot for [i=1:5] sel(p, word(methods, i)) using 4:5 with linespoints lt int(word(styles, i)) ps 0.4 notitle, \
       for [i=1:5] sel(p, word(methods, i)) using 4:($6==1 ? 10 : 1/0) with points lt int(word(styles, i)) pt 2 ps 0.7 notitle
}
# the legend, over the whole width
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.06
set key at screen 0.5,0.025 center center horizontal maxrows 1 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:5] NaN with linespoints lt int(word(styles, i)) ps 0.6 title word(methods, i)
unset multiplot
