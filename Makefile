# Weft. `make` builds the engine and the book and runs the first simulation; `make check` proves it; `make help` lists the rest.
SHELL := /bin/bash
.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SECONDARY:
.SUFFIXES:

CHAPTERS := $(shell tangle/chapters)
# EXTRA=path/to/my-chapter.nw adds a chapter that lives elsewhere
EXTRA    ?=
NW       := $(CHAPTERS) $(EXTRA)
CC       ?= cc
# gcc 12 makes fused vfmaddsub of a b +- c d in its vectorisers although contraction is off: another bit, so they are off too
STD      := -std=c11 -ffp-contract=off -fno-math-errno -fno-tree-vectorize
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wdouble-promotion -Wfloat-conversion -Wundef -Wvla $(WERROR)
CFLAGS   ?= -O2 -g
export MAKE EXTRA

.PHONY: all help clean watch renumber
all:
	@tangle/all

help:
	@echo "make                    install what is missing, tangle, build, weave, run the first simulation"
	@echo "make check              run every test (NO_INSTALL=1: with what is here)"
	@echo "make tangle             chapters to C: src-generated/ and build/lines/"
	@echo "make engine             the library: build/lib/ (ONLY=, WITHOUT= parts, or FOR=scene.json: an engine without the rest, in build/parts/)"
	@echo "make programs           the testbed, the headless testbed, the lab: build/bin/"
	@echo "make test               the unit tests"
	@echo "make book | html | pdf  weave: build/book/html/index.html, build/book/engine.pdf, methods.pdf, testbed.pdf, lab.pdf"
	@echo "                        (ONLY=, WITHOUT= or FOR=: the book of that engine alone, in build/parts/)"
	@echo "make upto CHAPTER=soft  the program as it stands after a chapter, compiled and tested (upto-all: every chapter, recorded)"
	@echo "make EXTRA=my.nw TARGET with a chapter of your own that lives elsewhere"
	@echo "make renumber           the chapters' files get the numbers of their places in book/plan.tsv"
	@echo "make watch              tangle, build and weave again whenever a chapter is saved"
	@echo "make data               measure again what the book's plots and tables show (book/data/; make clocks: only what has a clock in it)"
	@echo "make lab                the lab's sweeps, minutes (make lab-full: all of them): build/lab/*.csv; goes on when interrupted"
	@echo "make amalgam            the engine as two files: build/amalgam/weft.h, weft.c"
	@echo "make npm | python       packages for JavaScript (WebAssembly) and Python: build/npm, build/python"
	@echo "make peers              adapters for other engines: build/peers/bin/ (BOX2D3=its prefix)"
	@echo "make extremes           every engine on scenes with exact answers, swept past sense (the chapter extremes; long)"
	@echo "make parts              build and test the least engine, each part alone and left out;  make prices  what each costs"
	@echo "make mutate             plant mutants and count how many the tests catch (long)"
	@echo "make abuse CALLS=10000000 and make soak STEPS=1000000: random calls, and a long run, with everything checked"
	@echo "make exercise | try | grade | weave E=10.2 [NAME=ada], progress: exercises;  make teacher | assignment E=\"...\" | grade-all DIR=... | feedback | slides | papers: for teachers; make course: proves them"
	@echo "make install PREFIX=... and make uninstall;  make dist: a tarball that builds with a compiler and make alone;  make deb: Debian packages"
	@echo "make clean              remove build/"

renumber:
	@tangle/chapters --renumber

clean:
	rm -rf build

# Looks at the chapters twice a second; a save makes what depends on it.
watch:
	@echo "watching chapters/ -- stop with Ctrl-C"
	@last=; while sleep 0.5; do now=$$(cksum $$(tangle/chapters) $(EXTRA) | cksum); \
	  if [ "$$now" != "$$last" ]; then last=$$now; \
	    $(MAKE) --no-print-directory game && echo "$$(date +%T) the game is new" && $(MAKE) --no-print-directory engine && { [ ! -x build/bin/weft-headless ] || $(MAKE) --no-print-directory programs; } && $(MAKE) --no-print-directory html && echo "$$(date +%T) made again" || echo "$$(date +%T) mend the error above and save again"; fi; done

include tangle/engine.mk
include tangle/book.mk
include tangle/check.mk
include tangle/elsewhere.mk
include tangle/course.mk
