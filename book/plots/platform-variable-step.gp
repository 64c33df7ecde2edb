plot_height = 620
load 'book/plots/style.gp'
set multiplot layout 2,1
set xrange [0:4]
set yrange [-2.5:3.6]
set ylabel 'place, m'
set key tmargin left horizontal
set title 'the step taken from the clock'
f = 'book/data/platform-variable-step.csv'
plot f skip 3 using ($1==0?$2:NaN):3 with lines title 'fast', '' skip 3 using ($1==1?$2:NaN):3 with lines title 'plain', \
     '' skip 3 using ($1==2?$2:NaN):3 with lines title 'busy'
set xlabel 'time, s'
set title 'a fixed step'
unset key
plot f skip 3 using ($1==0?$2:NaN):4 with lines title 'fast', '' skip 3 using ($1==1?$2:NaN):4 with lines title 'plain', \
     '' skip 3 using ($1==2?$2:NaN):4 with lines title 'busy'
unset multiplot
