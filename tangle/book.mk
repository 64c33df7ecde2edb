# book.mk: the book. `make html`, `make pdf`, `make book` (both); with FOR=scene.json, ONLY="parts" or WITHOUT="parts" that of a smaller engine,
# in build/parts/NAME/book. BUILD=dir puts it elsewhere; TOLERANT=1 tells errors and goes on;
# PAGE=60 (a file's number, its name or its path) weaves one chapter alone, as a page or a PDF, in seconds; TEACHER=1 keeps the solutions; STRICT=1 makes an equation that no code refers to an error.
BUILD    ?= build
W        := $(BUILD)/weave
HTML     := $(BUILD)/book/html
TEXDIR   := $(BUILD)/tex
BASES    := $(shell tangle/chapters --name $(NW))
ONLINE   := $(filter %.figures %.lab,$(BASES))
VOLUMES  := $(shell tangle/chapters --volumes | cut -f1)
LOOM     := $(wildcard tangle/*.lua) tangle/weave tangle/markup tangle/page
PAGEMETA  = -M figures=$(abspath $(HTML)) $(if $(TOLERANT),-M missing=true) $(if $(TEACHER),-M teacher=true) $(if $(filter chapters/testbed/%,$(NW)),-M testbed=true)

.PHONY: book html pdf figures slides
ifneq ($(CHOSEN),)
book html pdf: engine $(W)/figures.stamp
	@tangle/shrunk '$(PART_DIR)' '$(if $(FOR),for $(basename $(notdir $(FOR))),$(subst only nothing,without parts,$(subst +, ,$(PART_NAME))))' $@ $(PART_CHOICE) -- $(HTML) $(NW)
else
book: html pdf
endif

# -- the material: one pass over all chapters; the files in $(W) are written only when they change
$(W)/.stamp: $(NW) $(BUILD)/chapters.list $(LOOM) tangle/bib book/plan.tsv book/page.html $(wildcard book/glossary.tsv book/refs.bib book/cover.svg book/plots/*.gp book/data/*.csv tests/examples/*)
	@mkdir -p $(W) $(HTML)/data
	@tangle/bib $(W)
	@tangle/weave $(if $(TOLERANT),--tolerant) $(if $(STRICT),--strict) --html $(HTML) $(W) $(NW)
	@touch $@
$(W)/db.lua $(W)/files.lua: $(W)/.stamp ;
$(W)/%.md $(W)/%.lua: $(W)/.stamp ;
$(W)/%.assets: $(W)/figures.stamp ;

# -- figures: drawn by the program of the chapters, plotted from the data that the lab wrote
figures: $(W)/figures.stamp
$(W)/figures.stamp: $(W)/.stamp $(wildcard book/plots/*.gp book/data/*.csv) tangle/figures
	@tangle/figures $(W)/src $(BUILD) $(if $(TOLERANT),--tolerant)
	@touch $@

# -- HTML
ifneq ($(PAGE),)
html pdf:
	@file='$(firstword $(filter $(PAGE),$(NW)) $(foreach f,$(NW),$(if $(filter $(PAGE) $(PAGE)-% %-$(PAGE),$(basename $(notdir $f))),$f)))'; \
	[ -n "$$file" ] || { echo "book: no chapter $(PAGE) -- PAGE=60, PAGE=leapfrog or its file, with EXTRA= where it lives elsewhere" >&2; exit 2; }; \
	BUILD=$(BUILD) TEACHER=$(TEACHER) tangle/preview "$$file" $(BUILD)/page $@
else ifeq ($(CHOSEN),)
html: $(BASES:%=$(HTML)/%.html) $(HTML)/formulas.html $(HTML)/glossary.html $(HTML)/book.css $(HTML)/book.js $(HTML)/live.js $(HTML)/spoken.js $(HTML)/address.js $(HTML)/fingers.js $(HTML)/testbed.html $(HTML)/live-testbed.js $(HTML)/gallery.html $(HTML)/fonts/.stamp
endif
$(HTML)/%.html: $(W)/%.md $(W)/%.lua $(W)/db.lua tangle/filter.lua tangle/weave-code.lua tangle/contents.lua tangle/page book/page.html book/macros.tex $(W)/bib.lua $(W)/%.assets
	@tangle/page html $* $(W) $@ $(PAGEMETA)
	@echo "  html $*"
$(HTML)/extending.html $(TEXDIR)/ch/extending.tex: EXTENDING.md
$(W)/bib.lua: $(W)/.stamp ;
# -- slides: a page for each week of the course
SLIDES := $(patsubst %,$(HTML)/slides-%.html,1 2 3 4 5 6 7 8 9 10 11 12)
$(SLIDES): book/slides.html
slides: html $(SLIDES)
	@echo "slides: $(HTML)/slides-1.html to slides-12.html (blank, arrows; the browser prints them as a PDF)"
$(HTML)/book.css $(HTML)/book.js $(HTML)/testbed.html: $(HTML)/%: book/%
	@mkdir -p $(@D); cp $< $@
$(HTML)/live.js $(HTML)/spoken.js $(HTML)/address.js $(HTML)/fingers.js: $(HTML)/%: book/% tangle/bare
	@mkdir -p $(@D); tangle/bare $< > $@

# -- the gallery: every scene, drawn by the program that the figures' tree makes
$(HTML)/gallery.html: $(W)/figures.stamp tangle/gallery
	@if $(if $(PLAIN),:,$(MAKE) --no-print-directory -j2 -f tangle/programs.mk SRC=$(W)/src OUT=$(BUILD)/plain CC="$(CC)" CFLAGS="-O1" STD="$$(tangle/std)" WARN="-w") \
	    $(or $(PLAIN),$(BUILD)/plain)/bin/weft-headless >$(BUILD)/gallery.log 2>&1; then tangle/gallery $(or $(PLAIN),$(BUILD)/plain)/bin/weft-headless $(HTML); \
	 else echo "book: no gallery without weft-headless -- see $(BUILD)/gallery.log"; fi

# -- live figures: the tangled code as WebAssembly. Without the tools the pages keep their frozen figures.
$(HTML)/live-testbed.js: $(W)/figures.stamp tangle/web.mk tangle/web.first tangle/figures-of
	@if [ -f $(W)/src/lab/live_main.c ] && command -v clang wasm-ld >/dev/null && [ -f /usr/lib/wasm32-wasi/libc.a ]; then \
	   $(MAKE) --no-print-directory -f tangle/web.mk SRC=$(W)/src OUT=$(BUILD)/web CC="$(CC)" NW="$(NW)" LIVE=$(W)/live.list && \
	   rm -f $(HTML)/live-*.js && cp $(BUILD)/web/live-*.js $(HTML); \
	 else echo "book: no live figures without clang, wasm-ld and wasi-libc (Debian: clang lld wasi-libc libclang-rt-dev-wasm32); the pages keep their frozen ones"; fi

# The fonts travel with the pages (GUST and OFL licences allow it), so that they look alike on a machine that lacks them.
$(HTML)/fonts/.stamp:
	@mkdir -p $(@D)
	@for f in texgyrepagella-regular.otf texgyrepagella-bold.otf texgyrepagella-italic.otf texgyrepagella-bolditalic.otf texgyrepagella-math.otf; do \
	  p=$$(kpsewhich $$f 2>/dev/null) && [ -n "$$p" ] && cp "$$p" $(@D)/ || true; done
	@for f in Regular Bold Italic; do \
	  p=$$(find /usr/share/fonts /usr/local/share/fonts $$HOME/Library/Fonts /Library/Fonts -name "JetBrainsMono-$$f.ttf" 2>/dev/null | head -1); [ -z "$$p" ] || cp "$$p" $(@D)/; done
	@touch $@

# -- PDF
$(TEXDIR)/ch/%.tex: $(W)/%.md $(W)/%.lua $(W)/db.lua tangle/filter.lua tangle/weave-code.lua tangle/page book/macros.tex $(W)/bib.lua $(W)/%.assets
	@tangle/page latex $* $(W) $@ $(PAGEMETA)
# a PDF for each volume that has a chapter; what is not in the plan goes to the first
define volume
IN_$(1) := $(filter-out $(ONLINE),$(shell tangle/chapters --in $(1) $(NW)))
ifneq ($$(if $(CHOSEN)$(PAGE),,$$(IN_$(1))),)
pdf: $(BUILD)/book/$(1).pdf
endif
$(BUILD)/book/$(1).pdf: $$(IN_$(1):%=$(TEXDIR)/ch/%.tex) $(TEXDIR)/ch/glossary.tex book/book.tex tangle/pdf $(W)/figures.stamp
	@tangle/pdf $(BUILD) $(1)
endef
$(foreach v,$(VOLUMES),$(eval $(call volume,$(v))))
