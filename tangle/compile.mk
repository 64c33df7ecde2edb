# compile.mk: compiles one tangled tree.  make -f tangle/compile.mk SRC=build/lines OUT=build lib|test|programs
# Used for the developer build, for sanitizer and double builds, for `make upto`, and for builds from src-generated/.
SRC ?= src-generated
OUT ?= build
STD ?= -std=c11 -ffp-contract=off -fno-math-errno
WARN ?= -Wall -Wextra
CFLAGS ?= -O2 -g
UPTO ?= 99
TESTS ?= $(shell for t in tests/test_*.c; do n=$$(basename $$t | sed -E 's/test_0*([0-9]+)_.*/\1/'); [ "$$n" -le "$(UPTO)" ] 2>/dev/null && echo $$t; done)

LIBSRC := $(wildcard $(foreach d,core math collision dynamics engine,$(SRC)/$(d)/*.c))
LIBOBJ := $(LIBSRC:$(SRC)/%.c=$(OUT)/obj/%.o)
INC    := -I$(SRC)/include -I$(SRC)
# tests may use the lab's and testbed's tangled code too, all but their main programs
EXTSRC := $(filter-out %_main.c,$(wildcard $(SRC)/lab/*.c $(SRC)/testbed/*.c))
EXTOBJ := $(EXTSRC:$(SRC)/%.c=$(OUT)/obj/%.o)
TESTBIN := $(TESTS:tests/%.c=$(OUT)/tests/%)

.PHONY: lib test
.SECONDARY:
lib: $(OUT)/lib/libweft.a
$(OUT)/lib/libweft.a: $(LIBOBJ)
	@mkdir -p $(@D); rm -f $@; ar rcs $@ $^
$(OUT)/obj/%.o: $(SRC)/%.c
	@mkdir -p $(@D)
	$(CC) $(STD) $(WARN) $(CFLAGS) $(INC) -fPIC -MMD -MP -c $< -o $@
$(OUT)/lib/libweft-extra.a: $(EXTOBJ)
	@mkdir -p $(@D); rm -f $@; ar rcs $@ $^
$(OUT)/tests/%: tests/%.c $(OUT)/lib/libweft.a $(OUT)/lib/libweft-extra.a $(wildcard tests/*.h)
	@mkdir -p $(@D)
	$(CC) $(STD) $(WARN) $(CFLAGS) $(INC) -Itests $< $(OUT)/lib/libweft-extra.a $(OUT)/lib/libweft.a -lcmocka -lm -o $@
test: $(TESTBIN)
	@for t in $(TESTBIN); do echo "== $$t"; $$t || exit 1; done
-include $(LIBOBJ:.o=.d) $(EXTOBJ:.o=.d)
