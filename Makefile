# Weft. `make` builds the engine and the book and runs the first simulation; `make check` proves it; `make help` lists the rest.
SHELL := /bin/bash
.DEFAULT_GOAL := all
.DELETE_ON_ERROR:
.SECONDARY:

CHAPTERS := $(sort $(wildcard chapters/*.nw))
EXTRA    ?=
NW       := $(CHAPTERS) $(EXTRA)
CC       ?= cc
STD      := -std=c11 -ffp-contract=off -fno-math-errno
WARN     := -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wdouble-promotion -Wfloat-conversion -Wundef -Wvla -Werror
CFLAGS   ?= -O2 -g

include tangle/engine.mk
include tangle/book.mk
include tangle/check.mk
