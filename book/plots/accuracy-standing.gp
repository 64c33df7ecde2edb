# accuracy-standing: what has to stand, and what may not overlap, against the instructions of a frame.
plot_height = 460
load 'book/plots/style.gp'
file = 'book/data/accuracy-solvers-instructions.csv'
set multiplot layout 1,3 margins 0.12,0.985,0.30,0.92 spacing 0.03,0.11
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set yrange [5e-8:20]
set xrange [2e4:3e7]
set tics font ',11'
dials = 'substeps steps passes stiffness sequential exact'
dashes = '1 1 1 1 1 2'
styles = '1 3 2 6 4 6'
points = '7 9 5 4 13 6'
array P[3] = ['card-house', 'card-house', 'pile']
array C[3] = [5, 8, 8]
array T[3] = ['card house: way from its place', 'card house: overlap', 'pile: overlap']
sel(p, m) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, m, file)
unset key
set xlabel 'instructions of a frame'
do for [k=1:3] {
  set title T[k] textcolor rgb text font ',13' offset 0,-0.5
  c = C[k]
  if (k == 1) { set ylabel 'greatest share of the size'; set format y '10^{%T}' } else { unset ylabel; set format y '' }
  plot for [i=1:6] sel(P[k], word(dials, i)) using ($11/60):($10==0 && column(c) > 7e-8 ? column(c) : $10==0 ? 7e-8 : 1/0) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.5 dt int(word(dashes, i)) notitle, \
       for [i=1:6] sel(P[k], word(dials, i)) using ($11/60):($10==1 ? 10 : 1/0) with points lt int(word(styles, i)) pt 2 ps 0.7 notitle, \
       sel(P[k], 'substeps') using ($11/60):($3==4 ? column(c) : 1/0) with points pt 6 ps 1.4 lc rgb line notitle
}
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.12
set key at screen 0.5,0.05 center center horizontal maxrows 2 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:6] NaN with linespoints lt int(word(styles, i)) pt int(word(points, i)) dt int(word(dashes, i)) title word(dials, i)
unset multiplot
