# Two commands do everything on a machine with only Python >= 3.11:
#   make lab     open the workbook in JupyterLab
#   make test    install what is missing and run every test
# and for whoever writes pages:
#   make build   make the notebooks of their sources

PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
WORKERS ?= 2

.PHONY: lab test test-fast check build bench clean

lab: $(VENV)/learner
	$(BIN)/tflab lab

test: $(VENV)/developer check
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadscope
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadscope --nbval notebooks/en solutions/en

test-fast: $(VENV)/developer
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadscope -m "not browser and not slow" -x -q

check: $(VENV)/developer
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

build: $(VENV)/developer
	$(BIN)/tflab build

bench: $(VENV)/developer
	$(BIN)/pip install --quiet --constraint constraints.txt --editable ".[bench]"
	for script in benchmarks/[a-z]*.py; do \
	  case $$script in *_peer.py) ;; *) echo "== $$script"; $(BIN)/python $$script || exit 1;; esac; done

$(VENV)/learner: pyproject.toml constraints.txt
	test -x $(BIN)/pip || $(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --constraint constraints.txt --editable .
	touch $@

$(VENV)/developer: pyproject.toml constraints.txt
	test -x $(BIN)/pip || $(PYTHON) -m venv $(VENV)
	$(BIN)/pip install --quiet --constraint constraints.txt --editable ".[dev]"
	touch $@ $(VENV)/learner

clean:
	rm -rf $(VENV) build dist *.egg-info .pytest_cache .ruff_cache .hypothesis
