# accuracy-narrow: the error of a contact against the cost of a pair, by the corners of a disc; and the walk of GJK, step by step.
plot_height = 430
load 'book/plots/style.gp'
file = 'book/data/accuracy-narrow-instructions.csv'
pairs = 1000
set multiplot layout 1,2 margins 0.135,0.985,0.14,0.92 spacing 0.11,0
set termoption enhanced
set logscale xy
set format y '10^{%T}'
set tics font ',11'
set yrange [1e-8:3]
set xlabel 'instructions for a pair'
set ylabel 'mean error (share of the radius)'
set title 'discs made of corners' offset 0,-0.7
set key at graph 0.98,0.62 right font ',11' samplen 1.5
sel(m) = sprintf("< awk -F, '$1==\"%s\" && $2 > 0' %s", m, file)
one(m) = sprintf("< awk -F, '$1==\"%s\" && $2 == 0' %s", m, file)
set xrange [40:40000]
methods = 'sat gjk voronoi'
plot for [i=1:3] sel(word(methods, i)) using ($7/pairs):4 with linespoints lt i title word(methods, i).': place', \
     for [i=1:3] sel(word(methods, i)) using ($7/pairs):6 with linespoints lt i dt 2 ps 0.4 title word(methods, i).': depth', \
     for [i=1:3] one(word(methods, i)) using ($7/pairs):4 with points lt i ps 1 notitle, \
     one('sat') using ($7/pairs):4 with points pt 6 ps 2 lc rgb line notitle, \
     one('sat') using ($7/pairs):4:('  circles') with labels left offset 1.6,1.2 font ',11' notitle
unset logscale x
set xrange [0:10.5]
set xtics 2
set xlabel 'steps of the walk of GJK'
unset ylabel
set title 'distance of polygons' offset 0,-0.7
set key top right
plot sprintf("< awk -F, '$1==\"walk\"' %s", file) using 3:5 with linespoints lt 5 title 'worst', \
     '' using 3:4 with linespoints lt 1 title 'mean'
unset multiplot
