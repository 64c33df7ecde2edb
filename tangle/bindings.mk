# bindings.mk: the packages for JavaScript and Python.   make -f tangle/bindings.mk SRC=src-generated OUT=build npm | python
# npm: the engine with a game's parts as WebAssembly, packed by xz as in web.mk, within a script that needs nothing else. What the script has to know of the
# headers is read from them (tangle/bindings). Python: one file, made in the same way; it loads libweft.so.
SRC ?= src-generated
OUT ?= build
NPM := $(OUT)/npm
PYTHON := $(OUT)/python
VERSION := $(shell sed -nE 's/^\#define WF_VERSION_(MAJOR|MINOR|PATCH) //p' $(SRC)/include/weft/core.h | tr '\n' . | sed 's/\.$$//')
# what a game hardly asks for: other methods for the same, the report's names, saves (the script makes snapshots by itself), hooks
WITHOUT := quad-tree grid sweep-and-prune aabb-tree spatial-hash implicit-midpoint explicit-euler symplectic-euler rk4 sequential tolerance report save far fine-sums workers voronoi hooks materials distance more-forces
WEBCC ?= $(firstword $(foreach c,clang clang-19 clang-18 clang-17 clang-16 clang-15 clang-14,$(if $(shell command -v $(c)),$(c))))
WEBLD ?= $(firstword $(foreach c,wasm-ld wasm-ld-19 wasm-ld-18 wasm-ld-17 wasm-ld-16 wasm-ld-15 wasm-ld-14,$(if $(shell command -v $(c)),$(c))))
SYSROOT ?= /usr
RT := $(firstword $(wildcard $(shell $(WEBCC) -print-resource-dir 2>/dev/null)/lib/wasi/libclang_rt.builtins-wasm32.a /usr/lib/llvm-*/lib/clang/*/lib/wasi/libclang_rt.builtins-wasm32.a))
FLAGS = --target=wasm32-wasi --sysroot=$(SYSROOT) -Oz -flto $(shell tangle/std) -mbulk-memory -mnontrapping-fptoint -ffunction-sections -fdata-sections -DNDEBUG -DWF_FREESTANDING -DWF_ENGINE
# wasm-opt takes off a fiftieth; without it the package works as well. Nothing lies below --global-base, so that it may put a constant part of
# an address into the load or the store, as it does for addresses below 1024.
OPT := $(if $(shell command -v wasm-opt),wasm-opt -Oz --converge --low-memory-unused --enable-bulk-memory --enable-nontrapping-float-to-int --enable-sign-ext --enable-mutable-globals)
JS := $(SRC)/bindings/weft.js
GAME := $(OUT)/npm-obj/src
.PHONY: npm python
.DELETE_ON_ERROR:

npm: $(NPM)/weft-physics.js $(NPM)/index.mjs $(NPM)/index.d.ts $(NPM)/package.json $(NPM)/README.md $(NPM)/demo.html $(NPM)/LICENSE
	@echo "npm: $(NPM), $$(gzip -9nc $< | wc -c) bytes by gzip, the module $$(wc -c < $(OUT)/npm-obj/weft.wasm)"
$(OUT)/npm-obj/weft.wasm: $(JS) $(wildcard $(SRC)/*/*.c $(SRC)/*/*.h $(SRC)/include/weft/*.h) tangle/bindings.mk tangle/bindings.lua
	@rm -rf $(@D); mkdir -p $(@D)
	@if command -v noweb >/dev/null; then tangle/tangle --without '$(WITHOUT)' $(@D)/src $$(tangle/chapters); else cp -r $(SRC) $(@D)/src; fi
	@for c in $$(cd $(@D)/src && ls core/*.c math/*.c collision/*.c dynamics/*.c engine/*.c | grep -v draw.c); do \
	   $(WEBCC) $(FLAGS) -I$(@D)/src/include -I$(@D)/src -c $(@D)/src/$$c -o $(@D)/$$(echo $$c | tr / -).o || exit 1; done
	@$(WEBLD) --no-entry --gc-sections --lto-O3 -mllvm --inline-threshold=-100 -mllvm --enable-merge-functions --strip-all -z stack-size=262144 --global-base=1024 --export=__heap_base \
	   $$(tangle/bindings $(@D)/src exports $(JS) | sed 's/^/--export=/') -L$(SYSROOT)/lib/wasm32-wasi $(@D)/*.o -lc $(RT) -o $@
	@$(if $(OPT),$(OPT) $@ -o $@)
# comments and leading spaces go; what remains is as readable as before
$(NPM)/weft-physics.js: $(OUT)/npm-obj/weft.wasm book/live.js
	@mkdir -p $(@D); xz -c --format=lzma --lzma1=preset=9e,pb=0,nice=48 $< > $<.lzma
	@{ echo "/* weft-physics $(VERSION), MIT licence; made by make npm */"; echo "(() => {"; echo "'use strict';"; \
	   { sed -n '/const unpack = /,/^  };/p' book/live.js; tangle/bindings $(GAME) js $(JS); } | sed -E 's/^ +//; /^\/\//d; /^\/\*\*.*\*\/$$/d; /^\/\*\*/,/\*\/$$/d; s/ \/\/ .*//; /^$$/d'; \
	   printf 'const SIZE = %d, DATA = "' $$(wc -c < $<); base64 -w0 $<.lzma; echo '";'; echo "start();"; echo "})();"; } > $@
$(NPM)/index.mjs: $(NPM)/weft-physics.js
	@{ echo "import './weft-physics.js';"; echo "const weft = globalThis.Weft;"; echo "await weft.ready;"; \
	   echo "export const { $$(tangle/bindings $(GAME) types $(JS) | sed -nE 's/^export (const|class) ([A-Za-z]+).*/\2/p' | paste -sd, | sed 's/,/, /g') } = weft;"; echo "export default weft;"; } > $@
$(NPM)/index.d.ts: $(OUT)/npm-obj/weft.wasm
	@mkdir -p $(@D); tangle/bindings $(GAME) types $(JS) > $@
$(NPM)/package.json: tangle/bindings.mk
	@mkdir -p $(@D); printf '{\n  "name": "weft-physics",\n  "version": "%s",\n  "description": "2D rigid-body physics: the same bits on every machine",\n  "license": "MIT",\n  "type": "commonjs",\n  "main": "./weft-physics.js",\n  "module": "./index.mjs",\n  "types": "./index.d.ts",\n  "exports": { ".": { "types": "./index.d.ts", "import": "./index.mjs", "default": "./weft-physics.js" } },\n  "keywords": ["physics", "2d", "rigid body", "deterministic", "wasm", "game"],\n  "files": ["weft-physics.js", "index.mjs", "index.d.ts", "demo.html"]\n}\n' '$(VERSION)' > $@
$(NPM)/README.md: $(SRC)/bindings/npm.md tangle/bindings.mk
	@mkdir -p $(@D); sed '/^<!-- Weft:/,/-->/d' $< > $@
$(NPM)/demo.html: $(SRC)/bindings/demo.html tangle/bindings.mk
	@mkdir -p $(@D); sed '/^<!-- Weft:/,/-->/d' $< > $@
$(NPM)/LICENSE: LICENSE
	@mkdir -p $(@D); cp $< $@

python: $(PYTHON)/weft/__init__.py $(PYTHON)/weft/api.py $(PYTHON)/pyproject.toml $(PYTHON)/README.md $(PYTHON)/energy.py
	@echo "python: $(PYTHON); it loads libweft.so from WEFT_LIBRARY, from $(OUT)/lib or from where the system has it"
$(PYTHON)/weft/__init__.py: $(SRC)/bindings/weft.py
	@mkdir -p $(@D); cp $< $@
$(PYTHON)/weft/api.py: $(SRC)/bindings/api.py $(wildcard $(SRC)/include/weft/*.h) tangle/bindings.lua
	@mkdir -p $(@D); { cat $<; tangle/bindings $(SRC) python; } > $@
$(PYTHON)/pyproject.toml: tangle/bindings.mk
	@mkdir -p $(@D); printf '[project]\nname = "weft-physics"\nversion = "%s"\ndescription = "2D rigid-body physics: the same bits on every machine"\nrequires-python = ">=3.9"\nlicense = { text = "MIT" }\n\n[build-system]\nrequires = ["setuptools"]\nbuild-backend = "setuptools.build_meta"\n\n[tool.setuptools]\npackages = ["weft"]\n' '$(VERSION)' > $@
$(PYTHON)/README.md: $(SRC)/bindings/python.md tangle/bindings.mk
	@mkdir -p $(@D); sed '/^<!-- Weft:/,/-->/d' $< > $@
$(PYTHON)/energy.py: $(SRC)/bindings/energy.py
	@mkdir -p $(@D); cp $< $@
