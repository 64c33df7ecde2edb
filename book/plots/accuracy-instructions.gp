# accuracy-instructions: the same errors against the instructions of a frame, counted by valgrind.
file = 'book/data/accuracy-solvers-instructions.csv'
cost = 11; err = 5; fail = 10; what = 'instructions of 60 frames'
load 'book/plots/accuracy-solvers.gp'
