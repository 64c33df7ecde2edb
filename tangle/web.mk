# web.mk: the testbed and the figures as WebAssembly, in scripts that the book's pages load when a reader scrolls to something live.
#   make -f tangle/web.mk SRC=build/weave/src OUT=build/web [NW=chapters] [LIVE=a list of the figures that can move]
# Makes OUT/testbed.wasm, and for each chapter with figures OUT/figures-CHAPTER.wasm; and of each a script OUT/live-NAME.js that holds it,
# packed by xz, as text. With binaryen's wasm-split the testbed comes in two: testbed.wasm has the functions that OUT/first.list names, and
# testbed-rest.wasm what is asked for later; without it, in one. Needs clang, wasm-ld, xz, Debian's wasi-libc and clang's builtins for wasm32;
# the linker must not leave a single import: a module asks nothing of the page but its own rest.
# Of what binaryen's wasm-opt can do, two things make the testbed smaller when it is packed, by a hundredth: a constant part of an address goes into
# the load or the store (--low-memory-unused: nothing lies below --global-base, where such an address would mean another), and locals that are used
# most come first. (All of -Oz makes a module a sixth smaller, and what is packed of it not at all.)
SRC ?= build/weave/src
OUT ?= build/web
NW ?= $(shell tangle/chapters)
WEBCC ?= $(firstword $(foreach c,clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14,$(if $(shell command -v $(c)),$(c))))
WEBLD ?= $(firstword $(foreach c,wasm-ld wasm-ld-19 wasm-ld-18 wasm-ld-17 wasm-ld-16 wasm-ld-15 wasm-ld-14,$(if $(shell command -v $(c)),$(c))))
SPLIT ?= $(shell command -v wasm-split)
OPT := $(if $(shell command -v wasm-opt),wasm-opt --low-memory-unused --optimize-added-constants --reorder-locals -g)
FEATURES := --enable-bulk-memory --enable-simd --enable-nontrapping-float-to-int --enable-mutable-globals --enable-sign-ext
SYSROOT ?= /usr
RT := $(firstword $(wildcard $(shell $(WEBCC) -print-resource-dir 2>/dev/null)/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a))
FILES := $(filter-out %.schema.json,$(wildcard testbed/scenes/*.json))
CJSON_SRC ?= build/cjson
HAVE_CJSON := $(shell [ -d $(CJSON_SRC) ] || tangle/cjson $(CJSON_SRC) >&2; ls $(CJSON_SRC)/cjson/cJSON.c 2>/dev/null)
FLAGS = --target=wasm32-wasi --sysroot=$(SYSROOT) -Oz -std=gnu11 -ffp-contract=off -fno-math-errno -mbulk-memory -mnontrapping-fptoint \
         -flto -ffunction-sections -fdata-sections -DNDEBUG -DWF_ENGINE -DWF_NO_JSON -Dsnprintf=web_snprintf -Dvsnprintf=web_vsnprintf -I$(SRC)/include -I$(SRC) -I$(OUT) -idirafter $(STB)
LINK = $(WEBLD) --no-entry --gc-sections --global-base=1024 --lto-O2 -mllvm --enable-merge-functions -L$(SYSROOT)/lib/wasm32-wasi
FONT_SIZES := 13 26
FONT_FLAGS := --ascii
FONTCC = $(WEBCC) $(FLAGS)
ENGINE := $(sort $(foreach d,core math collision dynamics engine,$(wildcard $(SRC)/$(d)/*.c)))
GAME := $(sort $(filter-out %_main.c %/svg_file.c %/layer.c %/script.c %/reload.c %/system.c,$(wildcard $(SRC)/testbed/*.c)))
object = $(patsubst $(SRC)/%.c,$(OUT)/obj/%.o,$(1))
TESTBED := $(OUT)/obj/bare/memory.o $(call object,$(filter-out %/core/memory.c,$(ENGINE)) $(GAME) $(SRC)/testbed/web_main.c $(SRC)/testbed/web_files_main.c $(SRC)/testbed/web_print_main.c) $(OUT)/gen/font_atlas.o
FIGURES := $(call object,$(ENGINE) $(GAME) $(SRC)/testbed/web_print_main.c $(SRC)/figures/kit.c $(SRC)/lab/taste.c $(SRC)/lab/live_main.c) $(OUT)/gen/font_atlas.o

# -- the pages that show a figure which can be dragged or moves: those of the chapters that name it
LIVE ?= build/weave/live.list
PAGES := $(shell tangle/figures-of --pages $(LIVE) $(NW))

.PHONY: web
web: $(OUT)/live-testbed.js $(if $(HAVE_CJSON),$(OUT)/live-json.js) $(PAGES:%=$(OUT)/live-figures-%.js)
	@rm -f $(filter-out $^ $(if $(SPLIT),%-rest.js),$(wildcard $(OUT)/live-*.js))
.DELETE_ON_ERROR:
$(OUT)/obj/%.o: $(SRC)/%.c tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -MMD -MP -c $< -o $@
$(OUT)/obj/bare/memory.o: $(SRC)/core/memory.c tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(FLAGS) -DWF_FREESTANDING -c $< -o $@
# Most of a frame is mixing pixels: in lanes, which every browser has had since 2023, for speed and not for size; packed it is smaller all the same.
$(OUT)/obj/testbed/raster.o: FLAGS += -O2 -msimd128
include tangle/font.mk

# Scenes that are files: their names (each one's line "name") for the list; and their reader, a module of its own with cJSON from Debian's source (tangle/cjson), and their texts.
# Without that source the page's list has none; rm -r build/cjson, and it is asked for again. (Of libc's files the reader's module names three
# functions, for a library that could print; none is ever called.)
name_of = sed -n 's/^ *"name": "\([^"]*\)",$$/\1/p' $$f | head -1
$(OUT)/gen/files.h: tangle/web.mk $(FILES)
	@mkdir -p $(@D); { echo '/* made by tangle/web.mk */'; for f in $(if $(HAVE_CJSON),$(FILES)); do printf 'FILE_SCENE("%s")\n' "$$($(name_of))"; done; } > $@
$(OUT)/obj/testbed/web_files_main.o: $(OUT)/gen/files.h
READER := $(patsubst %,$(OUT)/obj/reader/%.o,$(notdir $(basename $(wildcard $(SRC)/json/*.c))) memory json_main cJSON)
$(OUT)/obj/reader/%.o: tangle/web.mk
	@mkdir -p $(@D); $(WEBCC) $(filter-out -DWF_NO_JSON,$(FLAGS)) -isystem $(CJSON_SRC) -MMD -MP -c $(firstword $(wildcard $(SRC)/json/$*.c $(SRC)/core/$*.c $(SRC)/testbed/$*.c $(CJSON_SRC)/cjson/$*.c)) -o $@
$(OUT)/json.wasm: $(READER) $(filter-out %/core/memory.o,$(call object,$(ENGINE))) $(OUT)/obj/testbed/web_print_main.o
	@$(LINK) --strip-all $^ -lc $(RT) -o $@
$(OUT)/live-json.js: $(OUT)/json.wasm.lzma $(FILES)
	@{ printf 'WEFT_FILES={'; for f in $(FILES); do printf '"%s":"%s",' "$$($(name_of))" "$$(base64 -w0 $$f)"; done; \
	   printf '};\nWEFT_LIVE("json",%d,"' $$(wc -c < $(OUT)/json.wasm); base64 -w0 $<; printf '");\n'; } > $@
	@echo "web: json: $$(wc -c < $(OUT)/json.wasm) bytes, $$(wc -c < $<) packed"

# What nothing exported needs is left out: a page's figures bring neither rasteriser nor letters, and of the engine what they call.
# A page has files of its chapters' figures, cut down to those that it shows (gen/PAGE/figures), and a table of these files.
$(OUT)/gen/%/.stamp: $(wildcard $(SRC)/figures/*) $(wildcard $(LIVE)) tangle/figures-of $(NW)
	@mkdir -p $(@D); tangle/figures-of $(LIVE) $* $(SRC)/figures $(@D)/figures $(NW)
	@cat $(@D)/figures/* > $@.new && { cmp -s $@.new $@ && rm $@.new || mv $@.new $@; }
$(OUT)/obj/pages/%/.stamp: $(OUT)/gen/%/.stamp $(SRC)/figures/table.c $(SRC)/figures/kit.h
	@mkdir -p $(@D); rm -f $(@D)/*.o
	@for c in $(OUT)/gen/$*/figures/*.c $(SRC)/figures/table.c; do $(WEBCC) -I$(OUT)/gen/$* $(FLAGS) -w -c $$c -o $(@D)/$$(basename $$c .c).o || exit 1; done; touch $@
$(OUT)/figures-%.wasm: $(OUT)/obj/pages/%/.stamp $(FIGURES)
	@$(LINK) --strip-all $(OUT)/obj/pages/$*/*.o $(FIGURES) -lc $(RT) -o $@

# The whole testbed, with its functions' names; its two parts have none.
$(OUT)/whole.wasm: $(TESTBED)
	@$(LINK) --strip-debug -Map=$(OUT)/whole.map $^ -lc $(RT) -o $@
	@$(if $(OPT),$(OPT) $(FEATURES) $@ -o $@)
# Functions that the whole has under a name of the list; the compiler tells two of one name apart by a number.
$(OUT)/first.list: $(OUT)/whole.wasm tangle/web.first
	@sed -nE 's/.*:\(([^() ]+)\)$$/\1/p' $(OUT)/whole.map | awk 'NR == FNR { if (!/^#/) first[$$1]; next } { n = $$1; sub(/\.[0-9]+$$/, "", n); if (n in first) print $$1 }' tangle/web.first - | sort -u > $@
$(OUT)/testbed.wasm: $(OUT)/whole.wasm $(OUT)/first.list
ifneq ($(SPLIT),)
	@$(SPLIT) --quiet --split $(FEATURES) \
	  --keep-funcs=@$(OUT)/first.list $< -o1 $@ -o2 $(OUT)/testbed-rest.wasm
$(OUT)/testbed-rest.wasm: $(OUT)/testbed.wasm ;
$(OUT)/live-testbed.js: $(OUT)/live-testbed-rest.js
else
	@$(LINK) --strip-all $(TESTBED) -lc $(RT) -o $@
endif
$(OUT)/one.wasm: $(TESTBED)
	@$(LINK) --strip-all $(TESTBED) -lc $(RT) -o $@
$(OUT)/%.wasm.lzma: $(OUT)/%.wasm
	@xz -c --format=lzma --lzma1=preset=9e,pb=0,nice=96 $< > $@
$(OUT)/live-%.js: $(OUT)/%.wasm.lzma
	@{ printf 'WEFT_LIVE("%s",%d,"' $* $$(wc -c < $(OUT)/$*.wasm); base64 -w0 $<; printf '");\n'; } > $@
	@echo "web: $*: $$(wc -c < $(OUT)/$*.wasm) bytes, $$(wc -c < $<) packed"
.SECONDARY:
-include $(wildcard $(OUT)/obj/*/*.d)
