# engine.mk: from chapters to C, from C to the library, the programs and the tests.
# Developer builds compile build/lines/, whose #line directives name the chapters; src-generated/ is the same code for people.
# BUILD=dir puts everything that is made elsewhere (the committed src-generated/ is then left alone).
BUILD ?= build
LINES := $(BUILD)/lines
SUBMAKE = $(MAKE) --no-print-directory CC="$(CC)" CFLAGS="$(CFLAGS)" STD="$(STD)" WARN="$(WARN)" PREFIX="$(PREFIX)"
PREFIX ?= /usr/local

.PHONY: FORCE tangle engine game programs programs-double test upto upto-all install dist uninstall
tangle: $(BUILD)/tangle.stamp
# Which chapters there are is a source too: it changes when EXTRA does, or when a chapter goes.
$(BUILD)/chapters.list: FORCE
	@mkdir -p $(BUILD); echo '$(NW)' | cmp -s - $@ || echo '$(NW)' > $@
FORCE: ;
$(BUILD)/tangle.stamp: $(NW) $(BUILD)/chapters.list $(wildcard tangle/*.lua) tangle/tangle tangle/markup tangle/std Makefile
	@mkdir -p $(BUILD)
	@tangle/tangle --lines $(LINES) $(NW)
	@$(if $(EXTRA)$(filter-out build,$(BUILD)),,tangle/tangle src-generated $(CHAPTERS) && tangle/std --readme)
	@touch $@

# The list of sources is known only after tangling, so a second make does the compiling.
# With ONLY="parts", WITHOUT="parts" or FOR=scene.json the engine has some of its parts alone; it is then made in build/parts/,
# with a tree for people (src) beside that of the compiler (lines), and everything else stays as it is. ONLY= (nothing) is the least engine.
CHOSEN := $(if $(filter command,$(firstword $(origin ONLY))),yes)$(if $(filter command,$(firstword $(origin WITHOUT))),yes)$(if $(filter command,$(firstword $(origin FOR))),yes)
FOR_PARTS = $(if $(FOR),$(shell tangle/needs '$(FOR)' || echo '?'))
NOTHING :=
SPACE := $(NOTHING) $(NOTHING)
PART_NAME ?= $(subst $(SPACE),+,$(strip $(if $(FOR),for $(basename $(notdir $(FOR)))) $(if $(filter command,$(firstword $(origin ONLY))),only $(or $(ONLY),nothing)) $(if $(WITHOUT),without $(WITHOUT))))
PART_DIR = $(if $(filter build,$(BUILD)),build/parts/$(PART_NAME),$(BUILD))
PART_CHOICE = $(if $(FOR),--only '$(FOR_PARTS)')$(if $(filter command,$(firstword $(origin ONLY))),--only '$(ONLY)') $(if $(WITHOUT),--without '$(WITHOUT)')
# Without noweb the engine is made from the committed C.
NOWEB := $(firstword $(wildcard $(addsuffix /mnt,$(NOWEB_LIB) /usr/lib/noweb /usr/local/lib/noweb /opt/homebrew/lib/noweb /opt/local/lib/noweb)))
ifeq ($(CHOSEN),)
engine: $(if $(NOWEB),$(BUILD)/tangle.stamp)
	@$(SUBMAKE) -f tangle/compile.mk SRC=$(if $(NOWEB),$(LINES),src-generated) OUT=$(BUILD) lib
else
.PHONY: parts-tangled
parts-tangled:
	@mkdir -p $(PART_DIR)
	@tangle/tangle --lines $(PART_CHOICE) $(PART_DIR)/lines $(NW)
	@tangle/tangle $(PART_CHOICE) $(PART_DIR)/src $(NW)
engine: parts-tangled
	@$(SUBMAKE) -f tangle/compile.mk SRC=$(PART_DIR)/lines OUT=$(PART_DIR) lib
	@echo "engine: $(PART_DIR)/lib, headers in $(PART_DIR)/src/include; its parts: $$(tr '\n' ' ' < $(PART_DIR)/lines/parts | sed 's/^$$/none/')"
endif
programs: $(BUILD)/tangle.stamp
	+@$(SUBMAKE) -f tangle/programs.mk SRC=$(LINES) OUT=$(BUILD) programs
# the lab and the headless testbed with doubles: for golden hashes, and for measurements whose names end in -double
programs-double: $(BUILD)/tangle.stamp
	@$(MAKE) --no-print-directory -f tangle/programs.mk SRC=$(LINES) OUT=$(BUILD)/double CC="$(CC)" CFLAGS="$(CFLAGS) -DWF_DOUBLE" STD="$(STD)" WARN="$(filter-out -Wdouble-promotion,$(WARN))" \
	   $(BUILD)/double/bin/weft-lab $(BUILD)/double/bin/weft-headless
game: $(BUILD)/tangle.stamp
	+@$(SUBMAKE) -f tangle/programs.mk SRC=$(LINES) OUT=$(BUILD) game
test: $(BUILD)/tangle.stamp
	@$(SUBMAKE) -f tangle/compile.mk SRC=$(LINES) OUT=$(BUILD) test

# The program as it stands after a chapter: tangled from the chapters up to it alone, in the order of book/plan.tsv, compiled, and tested.
# All chapters in turn (tests/upto/run.sh), each with the tests of its own.
UPTO_TESTS ?= tests
UPTO_DIR ?= $(BUILD)/upto/$(CHAPTER)
upto:
	@[ -n "$(CHAPTER)" ] || { echo "upto: which chapter? -- type: make upto CHAPTER=7, or CHAPTER=soft"; exit 2; }
	@files=$$(tangle/chapters --upto $(CHAPTER)) && tangle/tangle --lines $(UPTO_DIR)/lines $$files
	@$(MAKE) --no-print-directory -f tangle/compile.mk SRC=$(UPTO_DIR)/lines OUT=$(UPTO_DIR) \
	   CC="$(CC)" CFLAGS="-O1" TESTFLAGS=-O0 STD="$(STD)" WARN="$(WARN)" TESTS="$$(tangle/chapters --$(UPTO_TESTS) $(CHAPTER) | tr "\n" " ")" lib test
	@CC="$(CC)" tests/examples/small.sh $(UPTO_DIR) $(CHAPTER)
	@echo "upto: the program as it stands after chapter $(CHAPTER) compiles and passes its tests ($(UPTO_DIR))."
upto-all:
	@tests/upto/run.sh --all

# LIBDIR=lib64, or lib/x86_64-linux-gnu: where the system keeps its libraries
LIBDIR ?= lib
UP = $(shell echo '$(LIBDIR)' | sed 's|[^/][^/]*|..|g')
install: $(BUILD)/lib/libweft.a $(BUILD)/lib/libweft-collision.a $(BUILD)/lib/pkgconfig/weft.pc
	@install -d $(DESTDIR)$(PREFIX)/include/weft $(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig $(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/weft $(DESTDIR)$(PREFIX)/bin
	@install -m 644 src-generated/include/weft/*.h tangle/old_names.h $(DESTDIR)$(PREFIX)/include/weft/
	@install -m 644 $(BUILD)/lib/libweft.a $(BUILD)/lib/libweft-collision.a $(DESTDIR)$(PREFIX)/$(LIBDIR)/
	@cp -P $(BUILD)/lib/libweft.so* $(BUILD)/lib/libweft.dylib $(DESTDIR)$(PREFIX)/$(LIBDIR)/ 2>/dev/null || true
	@[ ! -f $(BUILD)/lib/weft.dll ] || { install -m 755 $(BUILD)/lib/weft.dll $(DESTDIR)$(PREFIX)/bin/; install -m 644 $(BUILD)/lib/libweft.dll.a $(DESTDIR)$(PREFIX)/$(LIBDIR)/; }
	@[ ! -f $(BUILD)/lib/libweft-json.a ] || install -m 644 $(BUILD)/lib/libweft-json.a $(DESTDIR)$(PREFIX)/$(LIBDIR)/
	@for p in $(BUILD)/lib/pkgconfig/*.pc; do sed 's|^prefix=.*|prefix=$(PREFIX)|; s|^libdir=.*|libdir=$${prefix}/$(LIBDIR)|' $$p > $(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig/$${p##*/}; done
	@install -m 644 $(BUILD)/lib/cmake/weft/weftConfigVersion.cmake $(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/weft/
	@sed 's|_weft_lib}/\.\.|_weft_lib}/$(UP)|' $(BUILD)/lib/cmake/weft/weftConfig.cmake > $(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/weft/weftConfig.cmake
	@for p in weft-testbed weft-headless weft-lab weft-rube; do [ -x $(BUILD)/bin/$$p ] && install -m 755 $(BUILD)/bin/$$p $(DESTDIR)$(PREFIX)/bin/ || true; done
	@echo "installed: headers in $(PREFIX)/include/weft, libraries in $(PREFIX)/$(LIBDIR), pkg-config name weft, CMake package weft"
# A tarball of what is committed: the same bytes whenever it is made. It builds with a compiler and make alone.
dist:
	@v=$$(sed -nE 's/^#define WF_VERSION_(MAJOR|MINOR|PATCH) //p' src-generated/include/weft/core.h | tr '\n' . | sed 's/\.$$//'); mkdir -p $(BUILD)/dist; \
	   git archive --format=tar --prefix=weft-$$v/ HEAD | gzip -n9 > $(BUILD)/dist/weft-$$v.tar.gz && echo "$(BUILD)/dist/weft-$$v.tar.gz: $$(wc -c < $(BUILD)/dist/weft-$$v.tar.gz) bytes, of commit $$(git rev-parse --short HEAD)"
uninstall:
	@rm -rf $(DESTDIR)$(PREFIX)/include/weft $(DESTDIR)$(PREFIX)/$(LIBDIR)/cmake/weft $(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig/weft.pc $(DESTDIR)$(PREFIX)/$(LIBDIR)/pkgconfig/weft-json.pc
	@rm -f $(DESTDIR)$(PREFIX)/$(LIBDIR)/libweft* $(DESTDIR)$(PREFIX)/bin/weft.dll $(addprefix $(DESTDIR)$(PREFIX)/bin/,weft-testbed weft-headless weft-lab weft-rube)
# one may be there without the others: the programs need no more than libweft.a
$(BUILD)/lib/libweft-collision.a: $(BUILD)/lib/libweft.a
$(BUILD)/lib/pkgconfig/weft.pc: $(BUILD)/lib/libweft-collision.a
$(BUILD)/lib/libweft.a $(BUILD)/lib/libweft-collision.a $(BUILD)/lib/pkgconfig/weft.pc:
	@$(if $(wildcard $(BUILD)/tangle.stamp),$(MAKE) --no-print-directory engine,$(SUBMAKE) -f tangle/compile.mk SRC=src-generated OUT=$(BUILD) lib)
