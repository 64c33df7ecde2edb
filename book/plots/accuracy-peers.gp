# accuracy-peers: other engines on the same scenes, error against the time of a frame.
plot_height = 640
load 'book/plots/style.gp'
file = 'book/data/accuracy-peers-time.csv'
set multiplot layout 2,3 margins 0.13,0.985,0.20,0.94 spacing 0.045,0.11
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set format y '10^{%T}'
set yrange [3e-8:20]
set xrange [1e-3:30]
set tics font ',11'
set datafile missing ''
engines = 'weft weft-double box2d2 box2d3 chipmunk planck rapier matter'
names = '"Weft" "Weft, double" "Box2D 2.4" "Box2D 3" "Chipmunk2D" "planck" "Rapier" "Matter.js"'
styles = '1 1 2 2 3 4 5 6'
points = '7 6 5 4 9 13 11 3'
dashes = '1 1 1 1 1 1 1 1'
sel(p, m, d) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\" && $3==\"%s\" && $5!=\"\"' %s", p, m, d, file)
scenes = 'pendulum double-pendulum chain stack slide roll'
unset key
do for [k=1:6] {
  p = word(scenes, k)
  set title p textcolor rgb text offset 0,-0.7
  if (k == 1 || k == 4) { set ylabel 'greatest error (share of the size)'; set format y '10^{%T}' } else { unset ylabel; set format y '' }
  if (k > 3) { set xlabel 'time of a frame (kernels)' } else { unset xlabel }
  plot for [i=1:8] sel(p, word(engines, i), 'steps') using 5:($6 > 4e-8 ? $6 : 4e-8) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.6 lw 1.5 notitle, \
       for [i=1:8] sel(p, word(engines, i), 'substeps') using 5:($6 > 4e-8 ? $6 : 4e-8) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.5 lw 1.2 dt 2 notitle, \
       for [i=1:8] sel(p, word(engines, i), 'iterations') using 5:($6 > 4e-8 ? $6 : 4e-8) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.4 lw 1.2 dt 3 notitle
}
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.08
set key at screen 0.5,0.035 center center horizontal maxrows 2 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:8] NaN with linespoints lt int(word(styles, i)) pt int(word(points, i)) title word(names, i)
unset multiplot
