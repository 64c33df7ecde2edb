# programs.mk: the programs of one tangled tree.  make -f tangle/programs.mk SRC=build/lines OUT=build programs
# Makes, in OUT/bin, those whose chapter is in the tree: weft-lab, weft-figures, weft-headless, weft-testbed.
# stb (fonts, PNG) and SDL2 (the window) are needed by single programs; what is missing is named and left out.
include tangle/compile.mk

mainof = $(wildcard $(SRC)/$(1))
SDL_LIBS := $(shell pkg-config --libs sdl2 2>/dev/null)
SDL_INC  := $(patsubst -I%,-isystem %,$(shell pkg-config --cflags sdl2 2>/dev/null))
PROGRAMS := $(if $(call mainof,lab/lab_main.c),weft-lab) $(if $(call mainof,lab/figures_main.c),weft-figures)
LACK := $(if $(CJSON),,no scenes as text without cJSON (Debian: libcjson-dev, Fedora: cjson-devel);)
ifneq ($(call mainof,testbed/bake_font_main.c),)
  ifeq ($(FONT),)
    LACK += the testbed has no text without DejaVuSans.ttf (Debian: fonts-dejavu-core, Fedora: dejavu-sans-fonts);
  endif
  ifeq ($(STB),)
    LACK += no weft-headless and weft-testbed without stb (Debian: libstb-dev, Fedora: stb-devel);
  else
    PROGRAMS += $(if $(call mainof,testbed/game.c),weft-headless)
    ifneq ($(call mainof,testbed/game.c),)
      ifeq ($(SDL_LIBS),)
        LACK += no weft-testbed without SDL2 (Debian: libsdl2-dev, Fedora: SDL2-devel);
      else
        PROGRAMS += weft-testbed
      endif
    endif
  endif
endif

# the scenes of the chapter performance in Box2D 3, if its prefix is named: BOX2D3=/usr/local
BOX2D3 ?=
# as peers.mk takes it, it may be NAME=PREFIX, and several: the first one serves here
BOX2D3_AT := $(lastword $(subst =, ,$(firstword $(BOX2D3))))
PROGRAMS += $(if $(BOX2D3),$(if $(call mainof,lab/box2d_main.c),weft-box2d))

# writes the heavy scenes of the chapter performance as text
PROGRAMS += $(if $(CJSON),$(if $(call mainof,lab/load_main.c),weft-load))

# translates scenes of R.U.B.E.; a tool of its own, outside the chapters
PROGRAMS += $(if $(JSONOBJ),$(if $(call mainof,json/scene.h),$(if $(wildcard tools/rube/main.c),weft-rube)))

.PHONY: programs
programs: $(PROGRAMS:%=$(OUT)/bin/%)
	@$(if $(strip $(LACK)),echo "programs: $(LACK) install them and say make again")

# A program: its main file, what it needs beside the libraries, the libraries.
LINK = @mkdir -p $(@D); $(CC) $(CFLAGS) $(LDFLAGS) $(filter %.o,$^) $(WEFT_LIBS) $(CJSON) $(1) -lm -o $@
$(OUT)/bin/weft-lab: $(OUT)/obj/lab/lab_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-load: $(OUT)/obj/lab/load_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-rube: tools/rube/main.c tools/rube/rube.c tools/rube/rube.h $(JSONLIB) $(OUT)/lib/libweft.a
	@mkdir -p $(@D); $(if $(V),,echo "  cc tools/rube";) $(COMPILE) $(LDFLAGS) $(filter %.c %.a,$^) $(CJSON) -lm -o $@
$(OUT)/bin/weft-figures: $(OUT)/obj/lab/figures_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-headless: $(OUT)/obj/testbed/headless_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-testbed: $(OUT)/obj/testbed/sdl_main.o $(WEFT_LIBS)
	$(call LINK,$(SDL_LIBS))
# The game as a library that a running testbed takes up: its own engine inside, put in place in one go.
GAMEOBJ := $(filter $(OUT)/obj/testbed/%,$(EXTOBJ)) $(FONTOBJ)
$(OUT)/lib/libweft-game.so: $(GAMEOBJ) $(WEFT_LIBS)
	@mkdir -p $(@D); $(CC) $(CFLAGS) -shared -Wl,-Bsymbolic $(GAMEOBJ) $(WEFT_LIBS) $(CJSON) -lm -o $@.new && mv $@.new $@
.PHONY: game
game: $(OUT)/lib/libweft-game.so
$(OUT)/bin/weft-box2d: $(SRC)/lab/box2d_main.c
	@mkdir -p $(@D); $(CC) -O2 -isystem $(BOX2D3_AT)/include $< -L$(BOX2D3_AT)/lib -lbox2d -lm -lpthread -o $@
$(OUT)/obj/testbed/sdl_main.o: private INC += $(SDL_INC)
-include $(wildcard $(OUT)/obj/lab/*_main.d $(OUT)/obj/testbed/*_main.d)
