# web.mk: the testbed and the figures as WebAssembly, in two scripts that the book's pages load when a reader scrolls to something live.
#   make -f tangle/web.mk SRC=build/weave/src OUT=build/web
# Makes OUT/testbed.wasm and OUT/figures.wasm, and of each a script OUT/live-NAME.js that holds it, packed by xz, as text. Needs clang,
# wasm-ld, xz, Debian's wasi-libc and clang's builtins for wasm32; the linker must not leave a single import: a module asks nothing of the page.
# (binaryen's wasm-opt makes the module a sixth smaller, and what is packed of it not at all: it isn't used.)
SRC ?= build/weave/src
OUT ?= build/web
WEBCC ?= $(firstword $(foreach c,clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14,$(if $(shell command -v $(c)),$(c))))
WEBLD ?= $(firstword $(foreach c,wasm-ld wasm-ld-19 wasm-ld-18 wasm-ld-17 wasm-ld-16 wasm-ld-15 wasm-ld-14,$(if $(shell command -v $(c)),$(c))))
SYSROOT ?= /usr
RT := $(firstword $(wildcard $(shell $(WEBCC) -print-resource-dir 2>/dev/null)/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a))
FLAGS = --target=wasm32-wasi --sysroot=$(SYSROOT) -Oz -std=gnu11 -ffp-contract=off -fno-math-errno -mbulk-memory -mnontrapping-fptoint \
         -flto -ffunction-sections -fdata-sections -DNDEBUG -DWF_NO_JSON -Dsnprintf=web_snprintf -Dvsnprintf=web_vsnprintf -I$(SRC)/include -I$(SRC) -idirafter $(STB)
FONT_SIZES := 13 26
FONT_FLAGS := --ascii
FONTCC = $(WEBCC) $(FLAGS)
ENGINE := $(sort $(foreach d,core math collision dynamics engine,$(wildcard $(SRC)/$(d)/*.c)))
GAME := $(sort $(filter-out %_main.c %/svg_file.c %/layer.c %/script.c %/reload.c %/system.c,$(wildcard $(SRC)/testbed/*.c)))
object = $(patsubst $(SRC)/%.c,$(OUT)/obj/%.o,$(1))
TESTBED := $(OUT)/obj/bare/memory.o $(call object,$(filter-out %/core/memory.c,$(ENGINE)) $(GAME) $(SRC)/testbed/web_main.c $(SRC)/testbed/web_print_main.c) $(OUT)/gen/font_atlas.o
FIGURES := $(call object,$(ENGINE) $(GAME) $(SRC)/testbed/web_print_main.c $(SRC)/lab/figures.c $(SRC)/lab/taste.c $(SRC)/lab/live_main.c) $(OUT)/gen/font_atlas.o

.PHONY: web
web: $(OUT)/live-testbed.js $(OUT)/live-figures.js
.DELETE_ON_ERROR:
$(OUT)/obj/%.o: $(SRC)/%.c tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -MMD -MP -c $< -o $@
$(OUT)/obj/bare/memory.o: $(SRC)/core/memory.c tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -DWF_FREESTANDING -c $< -o $@
include tangle/font.mk
# What nothing exported needs is left out: the figures' module has neither rasteriser nor letters, the testbed's has no figure.
$(OUT)/testbed.wasm: $(TESTBED)
$(OUT)/figures.wasm: $(FIGURES)
$(OUT)/%.wasm:
	@$(WEBLD) --no-entry --gc-sections --strip-all --lto-O2 -mllvm --enable-merge-functions -L$(SYSROOT)/lib/wasm32-wasi $^ -lc $(RT) -o $@
$(OUT)/%.wasm.lzma: $(OUT)/%.wasm
	@xz -c --format=lzma --lzma1=preset=9e,pb=0,nice=273 $< > $@
$(OUT)/live-%.js: $(OUT)/%.wasm.lzma
	@{ printf 'WEFT_LIVE("%s",%d,"' $* $$(wc -c < $(OUT)/$*.wasm); base64 -w0 $<; printf '");\n'; } > $@
	@echo "web: $*: $$(wc -c < $(OUT)/$*.wasm) bytes, $$(wc -c < $<) packed"
.SECONDARY: $(OUT)/testbed.wasm.lzma $(OUT)/figures.wasm.lzma
-include $(wildcard $(OUT)/obj/*/*.d)
