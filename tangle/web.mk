# web.mk: the testbed and the figures as WebAssembly, in a script that the book's pages load when a reader scrolls to something live.
#   make -f tangle/web.mk SRC=build/weave/src OUT=build/web
# Makes OUT/weft.wasm and OUT/live-wasm.js. Needs clang, wasm-ld, Debian's wasi-libc and clang's builtins for wasm32; the linker must
# not leave a single import: the module asks nothing of the page.
SRC ?= build/weave/src
OUT ?= build/web
WEBCC ?= $(firstword $(foreach c,clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14,$(if $(shell command -v $(c)),$(c))))
WEBLD ?= $(firstword $(foreach c,wasm-ld wasm-ld-19 wasm-ld-18 wasm-ld-17 wasm-ld-16 wasm-ld-15 wasm-ld-14,$(if $(shell command -v $(c)),$(c))))
SYSROOT ?= /usr
RT := $(firstword $(wildcard $(shell $(WEBCC) -print-resource-dir 2>/dev/null)/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a))
STB := $(firstword $(foreach d,/usr/include/stb /usr/local/include/stb /opt/homebrew/include/stb /usr/include /usr/local/include,$(if $(wildcard $(d)/stb_sprintf.h),$(d))))
FLAGS := --target=wasm32-wasi --sysroot=$(SYSROOT) -Oz -std=gnu11 -ffp-contract=off -fno-math-errno -mbulk-memory -mnontrapping-fptoint \
         -ffunction-sections -fdata-sections -DNDEBUG -DWF_NO_JSON -Dsnprintf=web_snprintf -Dvsnprintf=web_vsnprintf -I$(SRC)/include -I$(SRC) -idirafter $(STB)
FONT_SIZES := 13 26
SOURCES := $(sort $(foreach d,core math collision dynamics engine,$(wildcard $(SRC)/$(d)/*.c)) \
           $(filter-out %_main.c %/svg_file.c %/layer.c %/script.c %/reload.c,$(wildcard $(SRC)/testbed/*.c)) $(SRC)/testbed/web_main.c $(SRC)/testbed/web_print_main.c \
           $(SRC)/lab/figures.c $(SRC)/lab/taste.c $(SRC)/lab/live_main.c)
OBJECTS := $(SOURCES:$(SRC)/%.c=$(OUT)/obj/%.o) $(OUT)/obj/font_atlas.o

.PHONY: web
web: $(OUT)/live-wasm.js
.DELETE_ON_ERROR:
$(OUT)/obj/%.o: $(SRC)/%.c tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -MMD -MP -c $< -o $@
$(OUT)/obj/font_atlas.o: $(OUT)/gen/font_atlas.c
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -c $< -o $@
include tangle/font.mk
$(OUT)/obj/testbed/bake_font_main.o: INC :=
$(OUT)/obj/testbed/bake_font_main.o: $(SRC)/testbed/bake_font_main.c
	@mkdir -p $(@D); $(CC) -O1 -I$(SRC) -isystem $(STB) -c $< -o $@
$(OUT)/weft.wasm: $(OBJECTS)
	@$(WEBLD) --no-entry --gc-sections --strip-all -L$(SYSROOT)/lib/wasm32-wasi $^ -lc $(RT) -o $@
$(OUT)/live-wasm.js: $(OUT)/weft.wasm
	@{ printf 'WEFT_LIVE("'; base64 -w0 $<; printf '");\n'; } > $@
	@gzip -9c $< | wc -c | awk '{ printf "web: the module is %d KB compressed\n", $$1 / 1000 }'
-include $(wildcard $(OUT)/obj/*/*.d)
