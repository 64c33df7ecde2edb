# accuracy-broad: instructions of a search for pairs against pairs looked at for nothing; lists that miss pairs at the right edge.
plot_height = 460
load 'book/plots/style.gp'
file = 'book/data/accuracy-broad-instructions.csv'
bodies = 400; frames = 60
set logscale xy
set xlabel 'pairs looked at for nothing, for each that touches'
set ylabel 'instructions for a square in a frame'
set xrange [0.3:24]
set yrange [2000:16000]
set ytics (2000, 3000, 4000, 6000, 8000, 12000)
set linetype 7 lc rgb faint lw 2 pt 6 ps 0.7 dt 2
set linetype cycle 7
set format y '%.0f'
set key top center horizontal maxrows 3 samplen 1.5 font ',12'
methods = 'brute-force quad-tree grid spatial-hash sweep-and-prune aabb-tree dynamic-tree'
sel(m) = sprintf("< awk -F, '$1==\"%s\" && $3==0' %s", m, file)
set xtics add ('missed' 16)
set arrow 1 from 11.3,graph 0 to 11.3,graph 0.78 nohead lc rgb faint dt 2
plot for [i=1:7] sel(word(methods, i)) using 6:($8/bodies/frames) with linespoints lt i title word(methods, i), \
     sel('dynamic-tree') using 6:($2==0 ? $8/bodies/frames : 1/0) with points pt 6 ps 1.8 lc rgb line notitle, \
     sprintf("< awk -F, '!/^#/ && $7 > 0.001' %s", file) using (15):($8/bodies/frames) with points pt 2 ps 1.2 lw 2 lc rgb bad notitle, \
     sprintf("< awk -F, '!/^#/ && $7 > 0.001' %s", file) using (15):($8/bodies/frames):($3 > 0 ? sprintf("every %d-th frame: %.1f %%", $3, 100*$7) : sprintf("report's rule: %.0f %%", 100*$7)) with labels right offset -1,0 font ',11' textcolor rgb bad notitle
