# peers.mk: the adapters of the chapter adapters, by which other engines play our scenes.  make -f tangle/peers.mk SRC=build/lines OUT=build peers
# Makes those whose engine is there, and names the others. Programs are in OUT/peers/bin. Engines in JavaScript are
# packages of npm; they are put into OUT/peers/node_modules, at the versions of this list, and nowhere else.
#   BOX2D3=/usr/local   the prefix of an installed Box2D 3.2, or several: 'box2d3=/opt/a box2d3-plain=/opt/b'
include tangle/compile.mk
PACKAGES := matter-js@0.20.0 planck@1.4.2 @dimforge/rapier2d-compat@0.21.0 @dimforge/rapier2d-simd-compat@0.19.3 box2d3-wasm@5.2.0
BOX2D3 ?=
PEERS := $(OUT)/peers
BIN := $(PEERS)/bin
PEERSRC := $(SRC)/lab/peers
CXX ?= c++
comma := ,
has = $(shell echo '\#include <$(2)>' | $(1) -E - >/dev/null 2>&1 && echo yes)
CHIPMUNK := $(and $(CJSON),$(call has,$(CC) -x c,chipmunk/chipmunk.h))
BOX2D2 := $(and $(CJSON),$(call has,$(CXX) -x c++,box2d/b2_math.h))
NODE := $(and $(shell command -v node),$(shell command -v npm))
BOX2D3S := $(foreach b,$(BOX2D3),$(if $(findstring =,$(b)),$(b),box2d3=$(b)))
MODULES := matter planck rapier rapier-simd box2d3-web
MADE := $(if $(JSONOBJ),$(if $(wildcard $(PEERSRC)/weft_main.c),weft weft-double)) $(if $(CHIPMUNK),chipmunk) $(if $(BOX2D2),box2d2) $(if $(CJSON),$(foreach b,$(BOX2D3S),$(firstword $(subst =, ,$(b))))) $(if $(NODE),$(MODULES))
LACKS := $(if $(CJSON),,all engines in C without cJSON (Debian: libcjson-dev);) $(if $(CHIPMUNK),,Chipmunk2D (Debian: chipmunk-dev);) \
         $(if $(BOX2D2),,Box2D 2.4 (Debian: libbox2d-dev);) $(if $(NODE),,Matter.js$(comma) planck$(comma) Rapier and Box2D 3 for the web without node and npm;) \
         $(if $(BOX2D3),,Box2D 3 itself (BOX2D3=its prefix);)

.PHONY: peers
peers: $(MADE:%=$(BIN)/%)
	@echo "peers: $(strip $(MADE))"; $(if $(strip $(LACKS)),echo "peers: not here: $(strip $(LACKS))")

PEERFLAGS := -O2 -g -Wall -Wextra $(JSONINC)
$(PEERS)/obj/%.o: $(PEERSRC)/%.c $(PEERSRC)/peer.h
	@mkdir -p $(@D); $(CC) -std=c11 $(PEERFLAGS) -c $< -o $@
PEEROBJ := $(PEERS)/obj/scene.o $(PEERS)/obj/drive.o
$(BIN)/chipmunk: $(PEERSRC)/chipmunk_main.c $(PEEROBJ)
	@mkdir -p $(@D); $(CC) -std=gnu11 $(PEERFLAGS) $< $(PEEROBJ) -lchipmunk $(CJSON) -lm -o $@
$(BIN)/box2d2: $(PEERSRC)/box2d2_main.cpp $(PEEROBJ)
	@mkdir -p $(@D); $(CXX) -std=c++17 $(PEERFLAGS) $< $(PEEROBJ) -lbox2d $(CJSON) -lm -o $@
define box2d3
$(BIN)/$(1): $(PEERSRC)/box2d3_main.c $(PEEROBJ)
	@mkdir -p $$(@D); $(CC) -std=c11 $(PEERFLAGS) -isystem $(2)/include $$< $(PEEROBJ) -L$(2)/lib -lbox2d $(CJSON) -lm -lpthread -o $$@
endef
$(foreach b,$(BOX2D3S),$(eval $(call box2d3,$(firstword $(subst =, ,$(b))),$(lastword $(subst =, ,$(b))))))

# this engine, in floats and in doubles: the chapter extremes
DOUBLE := $(MAKE) --no-print-directory -f tangle/compile.mk SRC=$(SRC) OUT=$(OUT)/double CFLAGS="$(CFLAGS) -DWF_DOUBLE" WARN=-w
$(BIN)/weft: $(PEERSRC)/weft_main.c $(PEEROBJ) $(WEFT_LIBS)
	@mkdir -p $(@D); $(COMPILE) $< $(PEEROBJ) $(JSONLIB) $(OUT)/lib/libweft.a $(CJSON) -lm -o $@
$(BIN)/weft-double: $(PEERSRC)/weft_main.c $(PEEROBJ) $(LIBOBJ)
	@$(DOUBLE) $(OUT)/double/lib/libweft.a $(OUT)/double/lib/libweft-json.a
	@mkdir -p $(@D); $(COMPILE) -DWF_DOUBLE $< $(PEEROBJ) $(OUT)/double/lib/libweft-json.a $(OUT)/double/lib/libweft.a $(CJSON) -lm -o $@

# node finds packages in the folders above a module: so the modules are put beside them
$(PEERS)/node_modules/.made: tangle/peers.mk
	@mkdir -p $(PEERS); echo '{ "private": true, "type": "module" }' > $(PEERS)/package.json
	@echo "peers: npm install $(PACKAGES)"; cd $(PEERS) && npm install --no-audit --no-fund --no-save --loglevel=error $(PACKAGES) >npm.log 2>&1 || { tail -5 npm.log; echo "peers: npm could not install the packages -- see $(PEERS)/npm.log"; exit 1; }
	@touch $@
$(PEERS)/%.mjs: $(PEERSRC)/%.mjs ; @mkdir -p $(@D); cp $< $@
$(PEERS)/rapier-simd.mjs: $(PEERSRC)/rapier.mjs ; @mkdir -p $(@D); cp $< $@
$(PEERS)/box2d3-web.mjs: $(PEERSRC)/box2d3.mjs ; @mkdir -p $(@D); cp $< $@
$(MODULES:%=$(BIN)/%): $(BIN)/%: $(PEERS)/%.mjs $(PEERS)/scene.mjs $(PEERS)/drive.mjs $(PEERS)/node_modules/.made
	@mkdir -p $(@D); printf '#!/bin/sh\nexec node "$$(dirname "$$0")/../%s.mjs" "$$@"\n' $* > $@; chmod +x $@
