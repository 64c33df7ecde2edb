load 'book/plots/style.gp'
set xlabel 'coefficient of restitution e'
set ylabel 'share of the approach energy left'
set key top left
plot 'book/data/impulses-energy.csv' skip 3 using 1:3 with lines title 'e squared', \
     '' skip 3 using 1:2 with points lt 2 title 'after the resolver'
