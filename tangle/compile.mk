# compile.mk: compiles one tangled tree.
#   make -f tangle/compile.mk SRC=build/lines OUT=build lib        the engine: static, shared, collision alone, pkg-config, CMake
#   make -f tangle/compile.mk SRC=build/lines OUT=build test       tests/test_*.c (or TESTS=..., which may be none); TESTFLAGS=-O0: their own text so
# Used for the developer build, for sanitizer and double builds, for `make upto`, and for builds from src-generated/ alone.
SRC ?= src-generated
OUT ?= build
ifndef STD
STD := $(shell tangle/std)
endif
WARN ?= -Wall -Wextra
CFLAGS ?= -O2 -g
PREFIX ?= /usr/local
# the version, as core.h says it
version = $(shell sed -n 's/^\#define WF_VERSION_$(1) //p' $(SRC)/include/weft/core.h)
VERSION = $(call version,MAJOR).$(call version,MINOR).$(call version,PATCH)
# An engine with some of its parts alone (a file `parts` in its tree) runs the tests that say what they need, if it has that.
PARTS_FILE := $(wildcard $(SRC)/parts)
APPLY = $(shell for t in tests/test_*.c; do n=$$(sed -n 's|^/\* needs: \(.*\) \*/$$|\1|p' $$t); [ -n "$$n" ] || continue; ok=1; for w in $$n; do \
   [ $$w = nothing ] || grep -qx -- $$w $(PARTS_FILE) || ok=; done; [ -n "$$ok" ] && echo $$t; done)
TESTS ?= $(if $(PARTS_FILE),$(APPLY),$(ALL_TESTS))
ALL_TESTS = $(sort $(wildcard tests/test_*.c))

COMPONENTS := core math collision dynamics engine
sources = $(sort $(wildcard $(foreach d,$(1),$(SRC)/$(d)/*.c)))
objects = $(patsubst $(SRC)/%.c,$(OUT)/obj/%.o,$(call sources,$(1)))
LIBOBJ := $(call objects,$(COMPONENTS))
# what the lab, the figures and the testbed are made of, but for their main programs: linked into tests too
EXTOBJ := $(filter-out %_main.o,$(call objects,lab figures testbed))
# Scenes as text are a library of their own, which stands on cJSON. Without cJSON, or with CJSON= on purpose, it is left out,
# and what would use it is compiled with -DWF_NO_JSON.
CJSON   ?= $(shell pkg-config --libs libcjson 2>/dev/null)
JSONOBJ := $(if $(CJSON),$(call objects,json))
JSONLIB := $(if $(JSONOBJ),$(OUT)/lib/libweft-json.a)
JSONINC := $(if $(JSONOBJ),$(patsubst %,-isystem %,$(filter-out /usr/include,$(shell pkg-config --variable=includedir libcjson))),-DWF_NO_JSON)
INC    := -I$(SRC)/include -I$(SRC) $(JSONINC)
COMPILE = $(CC) $(STD) $(WARN) $(CFLAGS) $(INC)
TESTBIN := $(patsubst tests/%.c,$(OUT)/tests/%,$(if $(JSONOBJ),$(TESTS),$(filter-out tests/%_json.c,$(TESTS))))
# what a test or a program is linked with, in this order
EXTRA_LIB := $(if $(PARTS_FILE),,$(OUT)/lib/libweft-extra.a)
WEFT_LIBS := $(EXTRA_LIB) $(JSONLIB) $(OUT)/lib/libweft.a
SHARED := $(if $(findstring mingw,$(CC)),weft.dll,$(if $(filter Darwin,$(shell uname -s)),libweft.dylib,libweft.so))
AR := $(if $(findstring mingw,$(CC)),$(CC:gcc=)ar,ar)

# Objects are made again when the compiler or its flags change: a float object never meets a double one.
FLAGS := $(OUT)/flags
$(shell mkdir -p $(OUT); echo '$(CC) $(STD) $(CFLAGS) $(JSONINC)' | cmp -s - $(FLAGS) || echo '$(CC) $(STD) $(CFLAGS) $(JSONINC)' > $(FLAGS))

.PHONY: lib test tests
.SECONDARY:
.DELETE_ON_ERROR:
lib: $(OUT)/lib/libweft.a $(OUT)/lib/libweft-collision.a $(JSONLIB) $(JSONLIB:$(OUT)/lib/lib%.a=$(OUT)/lib/pkgconfig/%.pc) $(OUT)/lib/$(SHARED) $(OUT)/lib/pkgconfig/weft.pc $(OUT)/lib/cmake/weft/weftConfig.cmake $(OUT)/lib/cmake/weft/weftConfigVersion.cmake

$(LIBOBJ): HIDDEN := -fvisibility=hidden -DWF_ENGINE
# most of a frame is mixing pixels; its sums may be made in lanes, where no processor was named whose lanes round otherwise
$(OUT)/obj/testbed/raster.o: HIDDEN := $(if $(findstring -m,$(CFLAGS)),,$(if $(filter -O2,$(CFLAGS)),-O3 -ftree-vectorize))
$(OUT)/obj/%.o: $(SRC)/%.c $(FLAGS)
	@mkdir -p $(@D)
	@$(if $(V),,echo "  cc $<";) $(if $(V),set -x;) $(COMPILE) -fPIC -fno-semantic-interposition $(HIDDEN) -MMD -MP -c $< -o $@
archive = @mkdir -p $(@D); rm -f $@; $(AR) rcs $@ $^
$(OUT)/lib/libweft.a: $(LIBOBJ) ; $(archive)
$(OUT)/lib/libweft-collision.a: $(call objects,core math collision) ; $(archive)
$(OUT)/lib/libweft-json.a: $(JSONOBJ) ; $(archive)
include tangle/font.mk
$(OUT)/lib/libweft-extra.a: $(EXTOBJ) $(FONTOBJ) ; $(archive)
$(OUT)/lib/libweft.so: $(LIBOBJ)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -shared -Wl,-soname,libweft.so.$(call version,MAJOR) -o $@.$(VERSION) $^ -lm
	@ln -sf libweft.so.$(VERSION) $@.$(call version,MAJOR) && ln -sf libweft.so.$(call version,MAJOR) $@
$(OUT)/lib/libweft.dylib: $(LIBOBJ)
	@mkdir -p $(@D)
	@$(CC) $(CFLAGS) -dynamiclib -install_name @rpath/libweft.dylib -o $@ $^ -lm

# CC=x86_64-w64-mingw32-gcc: a DLL that shows what the headers declare, and its import library
$(OUT)/lib/weft.dll: $(LIBOBJ)
	@mkdir -p $(@D); grep -ohE '\bwf[A-Za-z0-9_]+' $(SRC)/include/weft/*.h | sort -u > $(OUT)/declared
	@{ echo EXPORTS; $(CC:gcc=)nm -g --defined-only $^ | awk 'NR == FNR { said[$$1]; next } NF == 3 && $$3 in said { print "  " $$3 ($$2 ~ /[DR]/ ? " DATA" : "") }' $(OUT)/declared - | sort -u; } > $(OUT)/weft.def
	@$(CC) $(CFLAGS) -shared -static-libgcc -Wl,--out-implib,$(@D)/libweft.dll.a -o $@ $^ $(OUT)/weft.def -lm

# Users of a double build must see the same reals as the library: the switch travels in the package files.
SWITCHES := $(filter -DWF_%,$(CFLAGS))
# And the flags that keep the same bits, for those whose own sums shall have them.
BITS = $(filter-out -std=%,$(STD))
$(OUT)/lib/pkgconfig/weft.pc $(OUT)/lib/pkgconfig/weft-json.pc: $(OUT)/lib/pkgconfig/%.pc: tangle/%.pc.in $(LIBOBJ)
	@mkdir -p $(@D)
	@sed -e 's|@PREFIX@|$(PREFIX)|' -e 's|@VERSION@|$(VERSION)|' -e 's|@SWITCHES@|$(SWITCHES)|' -e 's|@BITS@|$(BITS)|' $< > $@
$(OUT)/lib/cmake/weft/%.cmake: tangle/%.cmake.in $(LIBOBJ)
	@mkdir -p $(@D)
	@sed -e 's|@VERSION@|$(VERSION)|' -e 's|@SWITCHES@|$(SWITCHES)|' -e 's|@BITS@|$(BITS)|' $< > $@

$(OUT)/tests/%: tests/%.c $(FLAGS) $(WEFT_LIBS) $(wildcard tests/*.h)
	@mkdir -p $(@D)
	@$(COMPILE) $(TESTFLAGS) -Itests $< $(WEFT_LIBS) $(CJSON) -lcmocka -lm -o $@
tests: $(TESTBIN)
test: $(TESTBIN)
	@for t in $(TESTBIN); do $$t >$$t.log 2>&1 && echo "  ok    $$(basename $$t): $$(grep -c '^\[       OK' $$t.log) tests" || { echo "  FAIL  $$t"; grep -vE '^\[( RUN|       OK)' $$t.log | tail -40; exit 1; }; done
-include $(LIBOBJ:.o=.d) $(EXTOBJ:.o=.d) $(JSONOBJ:.o=.d)
