# accuracy-time: the same errors against time, in thousands of dependent multiplications and additions.
file = 'book/data/accuracy-solvers-time.csv'
cost = 4; err = 5; fail = 6; what = 'time of a frame (kernels)'
load 'book/plots/accuracy-solvers.gp'
