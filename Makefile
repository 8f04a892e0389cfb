# `make demo`, `make check` and `make test` do all the set-up on a fresh machine.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
WORKERS ?= 2
PYTEST := $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal

# Modules are compiled once, not anew by each process that the tests start.
unexport PYTHONDONTWRITEBYTECODE

.PHONY: demo check test test-all test-fast test-quick test-catalogue lint format types web docs build clean

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/.installed: pyproject.toml constraints.txt | $(BIN)/python
	$(PIP) -c constraints.txt "torch==$$(sed -n 's/^torch==//p' constraints.txt)"
	$(PIP) -c constraints.txt -e .
	touch $@

$(VENV)/.installed-dev: $(VENV)/.installed
	$(PIP) -c constraints.txt -e '.[dev]'
	touch $@

WEB_SOURCES := $(shell find web -path web/node_modules -prune -o -type f -print)

web/node_modules/.package-lock.json: web/package.json web/package-lock.json
	cd web && npm ci --no-audit --no-fund

tabletopgen_web/static/study.html: $(WEB_SOURCES) | web/node_modules/.package-lock.json
	cd web && npm run --silent check && npm run --silent build -- --logLevel warn

web: tabletopgen_web/static/study.html  ## the web pages, from TypeScript, with npm

demo: $(VENV)/.installed  ## a text and a picture to bundles, the Panda moves an object on each
	$(BIN)/python examples/demo.py --out out

check: $(VENV)/.installed-dev  ## lint, types and the quick tests, side by side
	$(MAKE) --jobs=3 --output-sync=target lint types test-quick

test: $(VENV)/.installed-dev  ## the test suite; shapes and types of arrays are checked in its fast part
	$(MAKE) test-fast
	$(PYTEST) -m slow

test-fast: $(VENV)/.installed-dev $(if $(shell command -v npm),web)
	TABLETOPGEN_CHECK_ARRAYS=1 $(PYTEST) -m "not slow"

test-quick: $(VENV)/.installed-dev  ## tests of less than a second each (tests/quick.py)
	$(PYTEST) -m "not slow" --quick

test-all: $(VENV)/.installed-dev  ## everything: all shipped bundles, categories and hostile inputs
	TABLETOPGEN_EXHAUSTIVE=1 TABLETOPGEN_EVERY_CATEGORY=1 $(MAKE) test

test-catalogue: $(VENV)/.installed-dev  ## checks of every category; TABLETOPGEN_RECORD_PROOFS=1 records what passes
	TABLETOPGEN_EVERY_CATEGORY=1 $(PYTEST) tests/catalogue

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(VENV)/.installed-dev
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

types: $(VENV)/.installed-dev
	$(BIN)/pyright

docs: $(VENV)/.installed-dev web  ## the documentation site, in build/docs
	$(BIN)/python -m sphinx -q -W --keep-going -c docs/site -d build/doctrees docs build/docs
	@echo "open build/docs/index.html"

build: $(VENV)/.installed-dev web  ## the wheel, installed apart from the checkout and tried there
	$(BIN)/python tests/installing/built_wheel.py dist

clean:
	rm -rf $(VENV) build dist out *.egg-info .pytest_cache .ruff_cache
