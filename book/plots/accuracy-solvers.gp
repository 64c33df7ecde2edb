# accuracy-solvers: error against the dial of a solver; failures at the top edge.
plot_height = 620
load 'book/plots/style.gp'
if (!exists("file")) file = 'book/data/accuracy-solvers.csv'
if (!exists("cost")) { cost = 4; err = 5; fail = 10; what = 'passes in a frame' }
set multiplot layout 2,3 margins 0.13,0.985,0.19,0.94 spacing 0.045,0.11
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set format y '10^{%T}'
set yrange [3e-8:20]
if (cost == 4 && err == 5 && fail == 10) { set xrange [0.8:50] }
set tics font ',11'
dials = 'substeps steps passes stiffness one-by-one sequential exact'
dashes = '1 1 1 1 1 1 2'
styles = '1 3 2 6 5 4 6'
points = '7 9 5 4 11 13 6'
sel(p, m) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, m, file)
scenes = 'pendulum double-pendulum chain stack slide roll'
unset key
do for [k=1:6] {
  p = word(scenes, k)
  set title p textcolor rgb text offset 0,-0.7
  if (k == 1 || k == 4) { set ylabel 'greatest error (share of the size)'; set format y '10^{%T}' } else { unset ylabel; set format y '' }
  if (k > 3) { set xlabel what } else { unset xlabel }
  plot for [i=1:7] sel(p, word(dials, i)) using cost:(column(err) > 4e-8 ? column(err) : 4e-8) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.5 dt int(word(dashes, i)) notitle, \
       for [i=1:7] sel(p, word(dials, i)) using cost:(column(fail)==1 ? 10 : 1/0) with points lt int(word(styles, i)) pt 2 ps 0.7 notitle, \
       sel(p, 'substeps') using cost:($3==4 ? column(err) : 1/0) with points pt 6 ps 1.4 lc rgb line notitle
}
# the legend, over the whole width
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.08
set key at screen 0.5,0.035 center center horizontal maxrows 2 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:7] NaN with linespoints lt int(word(styles, i)) pt int(word(points, i)) dt int(word(dashes, i)) title word(dials, i)
unset multiplot
