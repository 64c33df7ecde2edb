# programs.mk: the programs of one tangled tree.  make -f tangle/programs.mk SRC=build/lines OUT=build programs
# Makes, in OUT/bin, those whose chapter is in the tree: weft-lab, weft-figures, weft-headless, weft-testbed.
# stb (font baking, PNG) and SDL2 (the window) are needed by single programs; what is missing is named and left out.
include tangle/compile.mk

STB  := $(firstword $(foreach d,/usr/include/stb /usr/local/include/stb /opt/homebrew/include/stb /usr/include /usr/local/include,$(if $(wildcard $(d)/stb_truetype.h),$(d))))
FONT ?= $(firstword $(wildcard /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf /usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf \
          /usr/share/fonts/TTF/DejaVuSans.ttf /Library/Fonts/DejaVuSans.ttf $(HOME)/Library/Fonts/DejaVuSans.ttf))
SDL_CFLAGS := $(shell pkg-config --cflags sdl2 2>/dev/null)
SDL_LIBS   := $(shell pkg-config --libs sdl2 2>/dev/null)
FONT_SIZES ?= 9 10 11 12 13 14 15 16 18 20 22 24 26 28 32 36 40 44

WEFT_LIBS := $(OUT)/lib/libweft-extra.a $(OUT)/lib/libweft.a
mainof = $(wildcard $(SRC)/$(1))
PROGRAMS := $(if $(call mainof,lab/lab_main.c),weft-lab) $(if $(call mainof,lab/figures_main.c),weft-figures)
LACK :=
ifneq ($(call mainof,testbed/bake_font_main.c),)
  ifeq ($(STB),)
    LACK += stb(Debian:libstb-dev,Fedora:stb-devel)
  else ifeq ($(FONT),)
    LACK += DejaVuSans.ttf(Debian:fonts-dejavu-core,Fedora:dejavu-sans-fonts)
  else
    PROGRAMS += $(if $(call mainof,testbed/headless_main.c),weft-headless)
    ifneq ($(call mainof,testbed/sdl_main.c),)
      ifeq ($(SDL_LIBS),)
        LACK += SDL2(Debian:libsdl2-dev,Fedora:SDL2-devel)
      else
        PROGRAMS += weft-testbed
      endif
    endif
  endif
endif

.PHONY: programs font
programs: $(PROGRAMS:%=$(OUT)/bin/%)
	@for l in $(foreach l,$(LACK),'$(l)'); do echo "programs left out: $$l is missing"; done
font: $(OUT)/gen/font_atlas.c

# A program: its main file, what it needs beside the libraries, the libraries.
LINK = @mkdir -p $(@D); $(CC) $(CFLAGS) $(LDFLAGS) $(filter %.o,$^) $(WEFT_LIBS) $(1) -lm -o $@
$(OUT)/bin/weft-lab: $(OUT)/obj/lab/lab_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-figures: $(OUT)/obj/lab/figures_main.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-headless: $(OUT)/obj/testbed/headless_main.o $(OUT)/obj/testbed/stb/png.o $(OUT)/gen/font_atlas.o $(WEFT_LIBS)
	$(call LINK)
$(OUT)/bin/weft-testbed: $(OUT)/obj/testbed/sdl_main.o $(OUT)/obj/testbed/stb/png.o $(OUT)/gen/font_atlas.o $(WEFT_LIBS)
	$(call LINK,$(SDL_LIBS))
$(OUT)/bin/bake-font: $(OUT)/obj/testbed/bake_font_main.o
	@mkdir -p $(@D); $(CC) $(CFLAGS) $(LDFLAGS) $< -lm -o $@

# stb's headers are not ours to keep free of warnings: they come in as system headers.
$(OUT)/obj/testbed/bake_font_main.o $(OUT)/obj/testbed/stb/png.o: private INC += -isystem $(STB)
$(OUT)/obj/testbed/sdl_main.o: private INC += $(patsubst -I%,-isystem %,$(SDL_CFLAGS))

$(OUT)/gen/font_atlas.c: $(OUT)/bin/bake-font $(FONT)
	@mkdir -p $(@D); $< $(FONT) $(FONT_SIZES) > $@.new && mv $@.new $@
$(OUT)/gen/font_atlas.o: $(OUT)/gen/font_atlas.c
	$(CC) $(STD) $(WARN) $(CFLAGS) $(INC) -c $< -o $@
-include $(wildcard $(OUT)/obj/lab/*_main.d $(OUT)/obj/testbed/*_main.d $(OUT)/obj/testbed/stb/*.d)
