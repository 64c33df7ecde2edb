# engine.mk: from chapters to C, from C to the library, the lab and the testbed.
# Developer builds compile build/lines/, whose #line directives name the chapters; src-generated/ is the same code for people.

LINES := build/lines
COMPONENTS := core math collision dynamics engine

.PHONY: tangle engine test
tangle: build/tangle.stamp
build/tangle.stamp: $(NW) $(wildcard tangle/*.lua) tangle/tangle
	@mkdir -p build
	@tangle/tangle --lines $(LINES) $(NW)
	@$(if $(EXTRA),,tangle/tangle src-generated $(CHAPTERS))
	@touch $@

# The list of sources is known only after tangling, so a second make does the compiling.
engine: build/tangle.stamp
	@$(MAKE) --no-print-directory -f tangle/compile.mk SRC=$(LINES) OUT=build CC="$(CC)" CFLAGS="$(CFLAGS)" STD="$(STD)" WARN="$(WARN)" lib
test: build/tangle.stamp
	@$(MAKE) --no-print-directory -f tangle/compile.mk SRC=$(LINES) OUT=build CC="$(CC)" CFLAGS="$(CFLAGS)" STD="$(STD)" WARN="$(WARN)" test
