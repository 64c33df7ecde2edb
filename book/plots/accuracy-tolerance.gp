# accuracy-tolerance: the true error of what was chosen, against the tolerance that was asked for: floats left, doubles right.
plot_height = 460
load 'book/plots/style.gp'
set multiplot layout 1,2 margins 0.15,0.98,0.28,0.91 spacing 0.03,0
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set format y '10^{%T}'
set tics font ',11'
set xrange [3e-10:0.3]
set yrange [1e-12:0.3]
set xtics 100
scenes = 'spring orbit projectile pendulum double-pendulum chain slide roll ball stack card-house'
array F[2] = ['book/data/accuracy-tolerance.csv', 'book/data/accuracy-tolerance-double.csv']
array T[2] = ['floats', 'doubles']
sel(f, p) = sprintf("< awk -F, '$1==\"%s\" && $3!=\"refused\"' %s", p, f)
dashes = '1 1 1 1 1 1 3 3 3 3 3'
unset key
set xlabel 'tolerance'
do for [k=1:2] {
  set title T[k] textcolor rgb text
  if (k == 1) { set ylabel 'true error' } else { unset ylabel; set format y '' }
  plot x with lines lc rgb faint dt 2 notitle, \
       for [i=1:11] sel(F[k], word(scenes, i)) using 2:($7 > 2e-12 ? $7 : 2e-12) with linespoints lt i dt int(word(dashes, i)) ps 0.5 notitle
}
# the legend, over the whole width
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.12
set key at screen 0.5,0.05 center center horizontal maxrows 2 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:11] NaN with linespoints lt i dt int(word(dashes, i)) ps 0.5 title word(scenes, i)
unset multiplot
