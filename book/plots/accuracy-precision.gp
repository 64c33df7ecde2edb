# accuracy-precision: error against substeps, by the numbers that the engine is compiled for; made worlds keep rests or do not.
plot_height = 520
load 'book/plots/style.gp'
set multiplot layout 2,3 margins 0.13,0.985,0.19,0.94 spacing 0.03,0.11
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set yrange [1e-11:1]
set xrange [0.7:2000]
set tics font ',11'
set ytics 100
array F[3] = ['book/data/accuracy-precision.csv', 'book/data/accuracy-precision.csv', 'book/data/accuracy-precision-double.csv']
array N[3] = ['float', 'float and rest', 'double']
array T[3] = ['float', 'float, fine sums', 'double']
sel(k, p) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, N[k], F[k])
scenes = 'pendulum double-pendulum chain stack slide roll'
unset key
do for [k=1:6] {
  p = word(scenes, k)
  set title p textcolor rgb text offset 0,-0.7
  if (k == 1 || k == 4) { set ylabel 'greatest error (share)'; set format y '10^{%T}' } else { unset ylabel; set format y '' }
  if (k > 3) { set xlabel 'substeps in a frame' } else { unset xlabel }
  plot for [i=1:3] sel(i, p) using 3:($4 > 2e-11 ? $4 : 2e-11) with linespoints lt i ps 0.5 notitle, \
       sel(2, p) using 3:($3==4 ? $4 : 1/0) with points pt 6 ps 1.4 lc rgb line notitle
}
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.08
set key at screen 0.5,0.03 center center horizontal maxrows 1 font ',12' samplen 2 width 3
plot [0:1][0:1] for [i=1:3] NaN with linespoints lt i title T[i]
unset multiplot
