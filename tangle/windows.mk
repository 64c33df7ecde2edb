# windows.mk: the testbed for Windows, made on Linux by mingw-w64.   make -f tangle/windows.mk SRC=build/lines OUT=build/windows
# Beside programs.mk: another compiler, another main file, no SDL and no scenes as text; the font is baked by font.mk, for the machine that builds.
SRC ?= build/lines
OUT ?= build/windows
WINCC ?= x86_64-w64-mingw32-gcc
STD := -std=gnu11 $(shell tangle/std --bits)
FLAGS = -O2 -DNDEBUG -DWF_NO_JSON -Wall -Wextra -Werror -I$(SRC)/include -I$(SRC) -isystem $(STB)
SOURCES = $(sort $(foreach d,core math collision dynamics engine,$(wildcard $(SRC)/$(d)/*.c)) $(filter-out %_main.c,$(wildcard $(SRC)/testbed/*.c)) \
          $(SRC)/testbed/win32_main.c)
FONTCC = $(WINCC) $(STD) $(FLAGS)
OBJECTS = $(SOURCES:$(SRC)/%.c=$(OUT)/obj/%.o) $(FONTOBJ)
.PHONY: windows
windows: $(OUT)/weft-testbed.exe
include tangle/font.mk
$(OUT)/obj/%.o: $(SRC)/%.c
	@mkdir -p $(@D); echo "  cc $<"; $(WINCC) $(STD) $(FLAGS) -MMD -MP -c $< -o $@
$(OUT)/weft-testbed.exe: $(OBJECTS)
	@$(WINCC) -O2 -static $^ -lgdi32 -o $@
-include $(wildcard $(OUT)/obj/*/*.d)
