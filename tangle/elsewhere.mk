# elsewhere.mk: the engine in two files, and the long runs against the whole world.
.PHONY: amalgam npm python abuse soak
# build/amalgam/weft.h and weft.c, from the chapters (EXTRA= too); without noweb from the committed C.
AMALGAM := $(BUILD)/amalgam
amalgam:
	@mkdir -p $(AMALGAM)
	@if command -v noweb >/dev/null; then tangle/tangle $(AMALGAM)/tree $(NW) && tangle/amalgam $(AMALGAM)/tree $(AMALGAM); else tangle/amalgam src-generated $(AMALGAM); fi
	@echo "$(AMALGAM)/weft.h, $(AMALGAM)/weft.c: $$(tangle/std --line)"
# build/npm: a package for JavaScript; build/python: one for Python. Nothing is published. (tangle/bindings.mk)
npm python: $(if $(NOWEB),tangle)
	@$(MAKE) --no-print-directory -f tangle/bindings.mk SRC=src-generated OUT=$(BUILD) $@
# CALLS random calls of the whole API of a world with everything checked behind each; writes book/data/abuse.csv.
CALLS ?= 10000000
SEED ?= 1
abuse:
	@OUT=book/data/abuse.csv tests/abuse/run.sh $(CALLS) $(SEED)
# STEPS steps of a scene with everything in it; writes book/data/soak.csv.
STEPS ?= 1000000
soak:
	@OUT=book/data/soak.csv tests/soak/run.sh $(STEPS)
# Debian packages of what is committed: build/deb/*.deb (tangle/packaging/debian; tangle/packaging/ has the port for vcpkg and the recipe for Conan too)
.PHONY: deb
deb: dist
	@rm -rf $(BUILD)/deb; mkdir -p $(BUILD)/deb; f=$$(echo $(BUILD)/dist/weft-*.tar.gz); v=$${f##*/weft-}; v=$${v%.tar.gz}; \
	   cp $$f $(BUILD)/deb/weft_$$v.orig.tar.gz && tar -xzf $$f -C $(BUILD)/deb && cp -r tangle/packaging/debian $(BUILD)/deb/weft-$$v/debian && cd $(BUILD)/deb/weft-$$v && \
	   env -u MAKEFLAGS -u MAKELEVEL -u MFLAGS dpkg-buildpackage -us -uc
	@tests/install/deb.sh
