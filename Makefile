# Two commands do everything on a machine with only Python >= 3.10:
#   make lab     open the workbook in JupyterLab;  make lab ARGS="--no-browser", ARGS="--lang ko"
#   make test    install what is missing and test; what was proved before and is unchanged is left out
# and for whoever changes it:
#   make test-changed  the tests that an edit can reach;  make test-changed BASE=main  all edits since main
#   make test-all      every test in full, and remember what is proved;  make test-all ARGS="tests/workbook"
# and for whoever writes pages:
#   make build     make the notebooks of their sources
#   make site      the book as a web site, in site/
#   make pictures  the pictures of the README and the site, of the pages
#   make patients  the robots that the exercises of chapter 12 examine
#   make fast      four pages of the engine, compiled beside their sources;  make test-compiled  and their tests

VENV := .venv
BIN := $(VENV)/bin
WORKERS ?= 2
ARGS ?=
BASE ?= HEAD
PAGES := notebooks/en solutions/en

NEW_ENOUGH := import sys; sys.exit(sys.version_info < (3, 10))
SAY_VERSION := import sys; print("%d.%d" % sys.version_info[:2])
# The Python that was named (make lab PYTHON=python3.12), else the one that .venv has, else the first that will do.
ifeq ($(origin PYTHON),undefined)
  PYTHON := $(shell for python in $(BIN)/python python3 python3.14 python3.13 python3.12 python3.11 python3.10; do \
    $$python -c '$(NEW_ENOUGH)' 2>/dev/null && echo $$python && break; done)
  PYTHON := $(or $(PYTHON),python3)
endif
VERSION := $(shell $(PYTHON) -c '$(SAY_VERSION)' 2>/dev/null)
LEARNER := $(VENV)/learner-$(VERSION)
DEVELOPER := $(VENV)/developer-$(VERSION)

.PHONY: lab test test-all test-changed check build site pictures patients fast test-compiled bench clean

lab: $(LEARNER)
	$(BIN)/tflab lab $(ARGS)

# The cells of a notebook run in one kernel and stay together; other tests go to whichever worker is free.
PYTEST := $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal -p no:nbval
NBVAL := $(BIN)/python -m pytest -n $(WORKERS) --dist loadscope --nbval $(PAGES)

test: $(DEVELOPER) check
	$(NBVAL)
	$(PYTEST)

test-all: $(DEVELOPER) check
ifeq ($(ARGS),)
	$(NBVAL) --all
	$(PYTEST) --all
else
	$(PYTEST) --all $(ARGS)
endif

test-changed: $(DEVELOPER) check
	tests=$$($(BIN)/python tests/changed.py $(BASE)) && { test -z "$$tests" || $(PYTEST) $$tests; }
	$(NBVAL)

check: $(DEVELOPER)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

build: $(DEVELOPER)
	$(BIN)/tflab build

site: $(DEVELOPER)
	$(BIN)/tflab build --html --reference --out site

pictures: $(DEVELOPER)
	$(BIN)/python docs/make_pictures.py

patients: $(DEVELOPER)
	$(BIN)/python docs/make_patients.py

fast: $(DEVELOPER)
	$(BIN)/python hatch_build.py

test-compiled: fast
	$(BIN)/python -c "import tflab.core; assert tflab.core.BUILD == 'compiled'"
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadscope tests/core tests/ros

bench: $(DEVELOPER)
	$(BIN)/python -m pip install --quiet --constraint constraints.txt --editable ".[bench]"
	for script in benchmarks/[a-z]*.py; do \
	  case $$script in *_peer.py) ;; *) echo "== $$script"; $(BIN)/python $$script || exit 1;; esac; done

define virtual_environment
@$(PYTHON) -c '$(NEW_ENOUGH)' 2>/dev/null || { \
  echo "tflab needs Python 3.10 or newer; here, $(PYTHON) is: $$($(PYTHON) -V 2>&1 || true)"; \
  echo "Install one (Debian, Ubuntu: apt-get install python3 python3-venv), or name one that is there: make lab PYTHON=python3.12"; \
  exit 1; }
@if test -e $(VENV) && test "$$($(BIN)/python -c '$(SAY_VERSION)' 2>/dev/null)" != "$(VERSION)"; then \
  echo "$(VENV) was made by another Python: making it anew, with $(VERSION)"; rm -rf $(VENV); fi
@test -x $(BIN)/python || $(PYTHON) -m venv $(VENV) || { rm -rf $(VENV); \
  echo "No virtual environment could be made. Debian, Ubuntu: apt-get install python3-venv"; exit 1; }
@$(BIN)/python -m pip --version >/dev/null 2>&1 || $(BIN)/python -m ensurepip
@echo "Installing what tflab needs into $(VENV): once, and some minutes on a slow line."
endef

# pip says some 350 lines: a line now and then is shown, and what went wrong; all of it is in the log.
LOG := $(VENV)/install.log
define SHORTLY
{ print > "$(LOG)" }
/^(Collecting|Processing) / && ++found % 25 == 0 { print "  " found " packages found" }
/^Installing collected packages/ { print "  " found " packages found, all there are; unpacking them takes longest" }
/^ *(ERROR|error):/ { print }
/^ended / { failed = $$2 }
{ fflush() }
END { print failed ? "Not installed. What pip said is in $(LOG)" : "  installed; what pip said is in $(LOG)"; exit failed }
endef
export SHORTLY

# $(call install,extras)
define install
@{ $(BIN)/python -m pip install --disable-pip-version-check --progress-bar off --constraint constraints.txt --editable ".[$(1)]" 2>&1; \
  echo "ended $$?"; } | awk "$$SHORTLY"
endef

$(LEARNER): pyproject.toml constraints.txt
	$(virtual_environment)
	$(call install,all)
	@touch $@

$(DEVELOPER): pyproject.toml constraints.txt
	$(virtual_environment)
	$(call install,dev)
	@touch $@ $(LEARNER)

clean:
	rm -f *.so tflab/core/*.so
	rm -rf $(VENV) build dist site *.egg-info .pytest_cache .ruff_cache .hypothesis
