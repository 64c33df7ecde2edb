# check.mk: what proves the rest. `make check` is kept under 25 minutes; the long runs have names of their own.
.PHONY: check mutate data golden coverage fuzz
SHARE ?= 1
check:
	@echo "[1/2] What the tests need"; $(if $(NO_INSTALL),NO_INSTALL=1) tangle/install check || echo "Going on with what is here; steps that lack a tool will fail."
	@echo "[2/2] The tests (tests/run --list names the steps; tests/run NAME runs one)"; tests/run
mutate:
	@tests/mutation/run.sh -n $(SHARE)
# Measures again everything that is deterministic and everything that is not, and writes book/data/.
data: programs
	@for m in $$(build/bin/weft-lab list | awk '{ print $$1 }'); do echo "measuring $$m"; build/bin/weft-lab run $$m > build/$$m.csv && mv build/$$m.csv book/data/$$m.csv || exit 1; done
# Records the hash of every scene; do it when a change of the engine's arithmetic is meant.
golden: programs
	@build/bin/weft-headless --record > tests/golden/scenes.csv && wc -l tests/golden/scenes.csv
# Which lines of collision do the unit tests run? Writes book/data/coverage.csv.
coverage:
	@OUT=book/data/coverage.csv tests/coverage/run.sh
# Feeds random bytes to collision for so many SECONDS; KEEP=1 keeps in tests/fuzz/corpus what was learned.
SECONDS ?= 600
fuzz:
	@tests/fuzz/run.sh $(SECONDS)
