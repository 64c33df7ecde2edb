# course.mk: coursework (appendix E). E="10.2 11.6" says which exercises, NAME=ada whose; tangle/course does the work.
.PHONY: exercise try grade weave progress teacher assignment grade-all feedback course papers
exercise try grade weave assignment:
	@BUILD=$(BUILD) NAME='$(NAME)' tangle/course $@ '$(E)'
progress teacher feedback:
	@BUILD=$(BUILD) NAME='$(NAME)' tangle/course $@
grade-all:
	@BUILD=$(BUILD) ROSTER='$(ROSTER)' DUE='$(DUE)' E='$(E)' tangle/course $@ '$(DIR)'
# every solution has full points, no starter has, every planted wrong solution loses
course:
	@BUILD=$(BUILD) tangle/course prove $(E)
# the weekly tests to be printed, a page a week (the teacher's edition has their answers)
papers: $(W)/.stamp
	@$(MAKE) --no-print-directory pdf PAGE=weekly-tests EXTRA=chapters/solutions/weekly-tests.nw
