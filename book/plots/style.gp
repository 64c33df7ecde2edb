# style.gp: what every plot shares.  A plot is book/plots/NAME.gp; it is run from the root of the repository as
#   gnuplot -e "out='build/.../NAME.svg'" book/plots/NAME.gp
# begins with  load 'book/plots/style.gp'  and names its data by book/data/NAME.csv (the CSV says which command measured it).
# Only these colours: the page's style sheet knows their dark counterparts.
if (!exists("out")) out = "/dev/stdout"
if (!exists("plot_height")) plot_height = 400
set terminal svg size 640,plot_height font 'sans-serif,14' linewidth 1.3 noenhanced background '#ffffff'
set output out
line = '#1f2933'; faint = '#87919c'; body = '#0067a5'; body2 = '#9c4279'; accent = '#a85800'; good = '#00775a'; bad = '#c4391a'; text = '#1a202c'
set linetype 1 lc rgb body   lw 2 pt 7 ps 0.6
set linetype 2 lc rgb accent lw 2 pt 5 ps 0.6
set linetype 3 lc rgb good   lw 2 pt 9 ps 0.7
set linetype 4 lc rgb body2  lw 2 pt 13 ps 0.7
set linetype 5 lc rgb bad    lw 2 pt 11 ps 0.7
set linetype 6 lc rgb line   lw 2 pt 4 ps 0.6
set linetype cycle 6
set border 3 lc rgb faint lw 1
set tics nomirror textcolor rgb text
set xlabel textcolor rgb text
set ylabel textcolor rgb text
set key textcolor rgb text noautotitle
set grid lc rgb faint lw 0.3 dt 3
set datafile separator ','
set datafile commentschars '#'
