load 'book/plots/style.gp'
set xlabel 'passes, or systems of equations'
set ylabel 'error, of that at the start'
set logscale y
set yrange [1e-13:3]
set termoption enhanced
set format y '10^{%T}'
set xrange [-4:200]
set key center right
plot 'book/data/exact-course.csv' skip 3 using 1:2 with linespoints title 'one by one', \
     '' skip 3 using 1:3 with linespoints title 'all at once'
