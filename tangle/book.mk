# book.mk: the book. `make html`, `make pdf`, `make book` (both). BUILD=dir puts it elsewhere; TOLERANT=1 tells errors and goes on;
# TEACHER=1 keeps the solutions.
BUILD    ?= build
W        := $(BUILD)/weave
HTML     := $(BUILD)/book/html
TEXDIR   := $(BUILD)/tex
BASES    := $(basename $(notdir $(NW)))
LOOM     := $(wildcard tangle/*.lua) tangle/weave tangle/page
PAGEMETA  = -M figures=$(abspath $(HTML)) $(if $(TOLERANT),-M missing=true) $(if $(TEACHER),-M teacher=true)

.PHONY: book html pdf figures
book: html pdf

# -- the material: one pass over all chapters; the files in $(W) are written only when they change
$(W)/.stamp: $(NW) $(LOOM) tangle/bib book/plan.tsv book/page.html $(wildcard book/refs.bib book/cover.svg book/plots/*.gp book/data/*.csv)
	@mkdir -p $(W) $(HTML)/data
	@tangle/bib $(W)
	@tangle/weave $(if $(TOLERANT),--tolerant) --html $(HTML) $(W) $(NW)
	@touch $@
$(W)/db.lua $(W)/files.lua: $(W)/.stamp ;
$(W)/%.md $(W)/%.lua: $(W)/.stamp ;

# -- figures: drawn by the program of the chapters, plotted from the data that the lab wrote
figures: $(W)/figures.stamp
$(W)/figures.stamp: $(W)/.stamp $(wildcard book/plots/*.gp book/data/*.csv) tangle/figures
	@tangle/figures $(W)/src $(BUILD) $(if $(TOLERANT),--tolerant)
	@touch $@

# -- HTML
html: $(BASES:%=$(HTML)/%.html) $(HTML)/formulas.html $(HTML)/book.css $(HTML)/book.js
$(HTML)/%.html: $(W)/%.md $(W)/%.lua $(W)/db.lua tangle/filter.lua tangle/weave-code.lua tangle/page book/page.html book/macros.tex $(W)/bib.lua | $(W)/figures.stamp
	@tangle/page html $* $(W) $@ $(PAGEMETA)
	@echo "  html $*"
$(W)/bib.lua: $(W)/.stamp ;
$(HTML)/book.css $(HTML)/book.js: $(HTML)/%: book/%
	@mkdir -p $(@D); cp $< $@

# -- PDF
$(TEXDIR)/ch/%.tex: $(W)/%.md $(W)/%.lua $(W)/db.lua tangle/filter.lua tangle/weave-code.lua tangle/page book/macros.tex $(W)/bib.lua | $(W)/figures.stamp
	@tangle/page latex $* $(W) $@ $(PAGEMETA)
pdf: $(BUILD)/book/weft.pdf
$(BUILD)/book/weft.pdf: $(BASES:%=$(TEXDIR)/ch/%.tex) book/book.tex tangle/pdf $(W)/figures.stamp
	@tangle/pdf $(BUILD)
