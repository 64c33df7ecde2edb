# font.mk: the baked font, a C file made from DejaVu Sans with stb_truetype at build time.
# Without stb or the font the tests and the testbed still link, with a font that has no letters.
# Here alone it is looked for stb and the font. Who makes programs for another machine (web.mk, windows.mk) sets  FONTCC  to the compiler
# of that machine before this file is read; the baker is then made for this one.
ifneq ($(wildcard $(SRC)/testbed/bake_font_main.c),)
STB  := $(firstword $(foreach d,/usr/include/stb /usr/local/include/stb /opt/homebrew/include/stb /usr/include /usr/local/include,$(if $(wildcard $(d)/stb_truetype.h),$(d))))
FONT ?= $(firstword $(wildcard /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf /usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf \
          /usr/share/fonts/TTF/DejaVuSans.ttf /Library/Fonts/DejaVuSans.ttf $(HOME)/Library/Fonts/DejaVuSans.ttf))
FONT_SIZES ?= 11 13 16 22 26 32
FONTOBJ := $(OUT)/gen/font_atlas.o

$(OUT)/gen/font_atlas.o: $(OUT)/gen/font_atlas.c
	@echo "  cc $<"; $(or $(FONTCC),$(CC) $(STD) $(WARN) $(CFLAGS) $(INC)) -c $< -o $@
ifeq ($(and $(STB),$(FONT)),)
$(OUT)/gen/font_atlas.c:
	@mkdir -p $(@D); printf '#include "testbed/font.h"\nconst wfFont wfBakedFont = {0};\n' > $@
else
# stb's headers are not ours to keep free of warnings: they come in as system headers.
ifeq ($(FONTCC),)
$(OUT)/obj/testbed/bake_font_main.o $(OUT)/obj/testbed/png.o: private INC += -isystem $(STB)
else
$(OUT)/obj/testbed/bake_font_main.o: $(SRC)/testbed/bake_font_main.c
	@mkdir -p $(@D); $(CC) -O1 -I$(SRC) -isystem $(STB) -c $< -o $@
endif
$(OUT)/bin/bake-font: $(OUT)/obj/testbed/bake_font_main.o
	@mkdir -p $(@D); $(CC) $(CFLAGS) $(LDFLAGS) $< -lm -o $@
$(OUT)/gen/font_atlas.c: $(OUT)/bin/bake-font $(FONT)
	@mkdir -p $(@D); $< $(FONT_FLAGS) $(FONT) $(FONT_SIZES) > $@.new && mv $@.new $@
endif
endif
