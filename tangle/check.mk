# check.mk: what proves the rest. `make check` should take at most 45 minutes on two cores; the long runs have names of their own.
.PHONY: pictures check check-all evaluation mutate data clocks golden coverage fuzz portability portability-ends portability-readme leaks windows parts prices peers extremes
SHARE ?= 1
check:
	@echo "[1/2] What the tests need"; $(if $(NO_INSTALL),NO_INSTALL=1) tangle/install check || echo "Going on with what is here; steps that lack a tool will fail."
	@echo "[2/2] The tests (tests/run --list names the steps; tests/run NAME runs one)"; tests/run
# The same and nothing taken from tests/passed.csv, where it is recorded what passed: to be committed with the change.
check-all:
	@ALL=1 $(MAKE) --no-print-directory check
mutate:
	@tests/mutation/run.sh -n $(SHARE)
# Measures again everything that is deterministic and everything that is not, and writes book/data/.
data: programs programs-double
	@tangle/measure
# Only those with a clock in them, each with the name of the machine: on a quiet one.
clocks: programs programs-double
	@tangle/measure --clock
# The sweeps of the lab (tangle/lab accuracy-peers-time after make peers, then copy its file to book/data), cell by cell, on all cores: build/lab/NAME.csv. Interrupted, it goes on. SWEEP="names" for some of them.
.PHONY: lab lab-full
lab: programs
	@tangle/lab $(SWEEP)
lab-full: programs
	@tangle/lab --full $(SWEEP)
# Records the hash of every scene; do it when a change of the engine's arithmetic is meant.
golden: programs programs-double
	@build/bin/weft-headless --record > tests/golden/scenes.csv && build/double/bin/weft-headless --record > tests/golden/scenes-double.csv
	@build/bin/weft-headless --schema > testbed/scenes/scene.schema.json
	@tests/json/run.sh --record > tests/golden/files.csv; wc -l tests/golden/*.csv
# Every scene on every platform that can be emulated; STEPS=n: other than the recorded number. Installs cross compilers and emulators
# (2 GB), goes on where it was interrupted, and writes book/data/portability.csv. run.sh --pack and --take let another machine run a part.
portability:
	@tangle/install portability || echo "Going on with what is here."
	@tests/portability/run.sh; rc=$$?; tests/portability/run.sh --table > build/portability/table.csv && cp build/portability/table.csv book/data/portability.csv; \
	   $(MAKE) --no-print-directory leaks; exit $$rc
# The same for worlds whose settings are at the ends of their ranges (tests/ends.h), on a platform of each kind; book/data/portability-ends.csv.
ENDS ?= gcc-O2 aarch64 armhf s390x wasm gcc-double aarch64-double s390x-double wasm-double
portability-ends:
	@tangle/install portability || echo "Going on with what is here."
	@tests/portability/run.sh --ends $(ENDS); rc=$$?; tests/portability/run.sh --ends --table > build/portability/ends.csv && cp build/portability/ends.csv book/data/portability-ends.csv; exit $$rc
# The line that README tells people to type, at every level of optimisation, by every gcc and clang that Debian has: one hash a scene?
# Installs the compilers, takes half an hour, goes on where it was interrupted, and writes book/data/portability-readme.csv.
portability-readme:
	@tests/portability/readme.sh --install; tests/portability/readme.sh; rc=$$?; tests/portability/readme.sh --table > build/portability/readme.csv && cp build/portability/readme.csv book/data/portability-readme.csv; exit $$rc
# What the forbidden flags do: builds whose bits must differ. After make golden; writes book/data/portability-leaks.csv.
leaks:
	@tests/portability/run.sh --leaks; mkdir -p build/portability; tests/portability/run.sh --leaks --table > build/portability/leaks.csv && cp build/portability/leaks.csv book/data/portability-leaks.csv
# Records the pictures of the testbed's panels and overlays anew. Look at them first: make pictures FULL=some/folder NAME="panel-world ..."
pictures: programs
	@tests/pictures/run.sh $(if $(FULL),--full $(FULL),--write) $(NAME)
# Which lines of collision do the unit tests run? Writes book/data/coverage.csv.
coverage:
	@OUT=book/data/coverage.csv tests/coverage/run.sh
# Feeds random bytes to collision for so many SECONDS; KEEP=1 keeps in tests/fuzz/corpus*.tar.gz what was learned.
SECONDS ?= 600
fuzz:
	@tests/fuzz/run.sh $(SECONDS)

# The testbed as a native program for Windows, and a test that uses it under Wine. BUILD/windows/weft-testbed.exe
windows: $(BUILD)/tangle.stamp
	@tangle/install windows testbed || echo "Going on with what is here."
	@$(MAKE) --no-print-directory -f tangle/windows.mk SRC=$(LINES) OUT=$(BUILD)/windows CC="$(CC)"
	@echo "made: $(BUILD)/windows/weft-testbed.exe"; tests/testbed/wine.sh

# The least engine, each part alone, each left out, and the whole; and what each part costs in lines and bytes (book/data/price-parts.csv).
parts:
	@tests/parts/run.sh
prices:
	@bash tests/parts/whole.sh && bash tests/parts/price.sh && bash tests/parts/list.sh

# Adapters by which other engines play our scenes, and this engine's own: build/peers/bin. BOX2D3= as in tangle/peers.mk
peers: $(BUILD)/tangle.stamp
	@$(if $(NO_INSTALL),NO_INSTALL=1) ONLY=1 tangle/install peers || echo "Going on with what is here."
	@$(SUBMAKE) -f tangle/peers.mk SRC=$(LINES) OUT=$(BUILD) BOX2D3='$(BOX2D3)' peers

# What the chapter evaluation says of each requirement, from the last run of the tests and from the measured data: book/data/evaluation.csv.
evaluation:
	@tests/evaluate/run.sh --record
# Every engine on scenes with exact answers, swept past sense, and the review that follows from it. The cells are kept
# in build/lab/cells: an interrupted sweep goes on.
extremes: programs peers
	@tangle/lab --full extremes && cp build/lab/extremes.csv book/data/extremes.csv && tests/peers/better.sh && tests/peers/features.sh --record && tests/peers/review.sh
