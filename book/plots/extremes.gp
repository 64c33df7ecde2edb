plot_height = 960
load 'book/plots/style.gp'
# a cell: an extreme (row) on an engine (column), with a bar for each value, from tame to wild
# columns in this order: this engine in its four forms, Box2D in its three, the others
place = "BEGIN { split(\"0 8 1 9 2 3 10 4 5 6 7\", o, \" \"); for (i in o) at[o[i]] = i - 1 } "
rows = "< awk -F, '".place."!/^#/ && $1 != \"extreme\" { if (!($1 in n)) { n[$1] = k++; name[k - 1] = $1 } if ($4 + 1 > most[$1]) most[$1] = $4 + 1; line[m++] = $0 } END { for (i = 0; i < m; i++) { split(line[i], f, \",\"); w = 0.9 / most[f[1]]; h = f[6] == \"right\" ? 0.8 : f[6] == \"stable\" ? 0.5 : 0.25; x = at[f[3]] + 0.05 + w * f[4]; print x + w / 2, -n[f[1]], x, x + 0.8 * w, -n[f[1]] - 0.4, -n[f[1]] - 0.4 + h, f[6] } }' book/data/extremes.csv"
names = system("awk -F, '!/^#/ && $1 != \"extreme\" && !($1 in n) { n[$1] = 1; printf \"%s \", $1 }' book/data/extremes.csv")
engines = system("awk -F, '".place."!/^#/ && $1 != \"extreme\" { gsub(/ /, \"_\", $2); name[at[$3]] = $2 } END { for (i = 0; i in name; i++) printf \"%s \", name[i] }' book/data/extremes.csv")
under(s) = (strstrt(s, '_') > 0 ? substr(s, 1, strstrt(s, '_') - 1) . "\n" . substr(s, strstrt(s, '_') + 1, strlen(s)) : strlen(s) > 9 ? substr(s, 1, 4) . "-\n" . substr(s, 5, strlen(s)) : s)
set datafile separator whitespace
set xrange [0:words(engines)]
set yrange [-words(names) + 0.4:0.6]
unset xtics
unset grid
set border 0
do for [i=1:words(engines)] { set label under(word(engines, i)) at i - 0.5, first 0.62 offset 0,1.5 center font ',10' textcolor rgb text }
do for [i=1:words(names)] { set ytics add (word(names, i) 1 - i) }
set ytics scale 0
do for [i=1:words(engines) - 1] { set arrow from i, 0.6 to i, -words(names) + 0.4 nohead lc rgb faint lw 0.5 }
set tmargin 3.5
set key at graph 0.5, -0.02 center top horizontal samplen 1 width -1 font ',12' textcolor rgb text
set bmargin 3
set style fill solid 1 noborder
plot rows using (strcol(7) eq 'right' ? $1 : 1/0):2:3:4:5:6 with boxxyerror lc rgb good title 'right', \
     rows using (strcol(7) eq 'stable' ? $1 : 1/0):2:3:4:5:6 with boxxyerror lc rgb accent title 'stable', \
     rows using (strcol(7) eq 'failed' ? $1 : 1/0):2:3:4:5:6 with boxxyerror lc rgb bad title 'failed', \
     rows using (strcol(7) eq 'crash' || strcol(7) eq 'slow' ? $1 : 1/0):2:3:4:5:6 with boxxyerror lc rgb line title 'crash or slow', \
     rows using (strcol(7) eq 'refused' || strcol(7) eq 'absent' ? $1 : 1/0):2:3:4:5:6 with boxxyerror lc rgb faint title 'refused'
