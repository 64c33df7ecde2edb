# accuracy-invariants: what should be kept, against passes in a frame.
plot_height = 560
load 'book/plots/style.gp'
file = 'book/data/accuracy-solvers.csv'
set multiplot layout 2,2 margins 0.13,0.98,0.19,0.94 spacing 0.10,0.13
set logscale xy
set termoption enhanced
set format x '10^{%T}'
set format y '10^{%T}'
set tics font ',11'
set xrange [0.9:90]
dials = 'substeps steps passes stiffness one-by-one sequential exact'
dashes = '1 1 1 1 1 1 2'
styles = '1 3 2 6 5 4 6'
points = '7 9 5 4 11 13 6'
sel(p, m) = sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\"' %s", p, m, file)
unset key
array P[4] = ['chain', 'chain', 'orbit', 'pile']
array C[4] = [6, 9, 7, 8]
array T[4] = ['chain: energy', 'chain: gap of the joints', 'orbit: angular momentum', 'pile: deepest overlap']
do for [k=1:4] {
  set title T[k] textcolor rgb text offset 0,-0.7
  c = C[k]
  if (k > 2) { set xlabel 'passes in a frame' }
  if (k % 2 == 1) { set ylabel 'greatest share' } else { unset ylabel }
  set yrange [*:*]
  plot for [i=1:7] sel(P[k], word(dials, i)) using 4:(column(c) > 0 ? column(c) : 1/0) with linespoints lt int(word(styles, i)) pt int(word(points, i)) ps 0.5 dt int(word(dashes, i)) notitle
}
# the legend, over the whole width
unset title; unset xlabel; unset ylabel; unset border; unset tics; unset logscale; unset grid
set lmargin at screen 0.02; set rmargin at screen 0.98; set bmargin at screen 0.0; set tmargin at screen 0.08
set key at screen 0.5,0.035 center center horizontal maxrows 2 font ',11' samplen 1.5 width 1
plot [0:1][0:1] for [i=1:7] NaN with linespoints lt int(word(styles, i)) pt int(word(points, i)) dt int(word(dashes, i)) title word(dials, i)
unset multiplot
