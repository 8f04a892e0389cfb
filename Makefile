# Two commands do all the set-up on a fresh machine: `make demo` and `make test`.
PYTHON ?= python3
VENV ?= .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip install --quiet --disable-pip-version-check
WORKERS ?= 2

.PHONY: demo test lint format types build bench clean

$(BIN)/python:
	$(PYTHON) -m venv $(VENV)

$(VENV)/.installed: pyproject.toml constraints.txt | $(BIN)/python
	$(PIP) -c constraints.txt "torch==$$(sed -n 's/^torch==//p' constraints.txt)"
	$(PIP) -c constraints.txt -e .
	touch $@

$(VENV)/.installed-dev: $(VENV)/.installed
	$(PIP) -c constraints.txt -e '.[dev]'
	touch $@

demo: $(VENV)/.installed  ## a text and a picture to bundles, the Panda moves an object on each
	$(BIN)/python examples/demo.py --out out

test: $(VENV)/.installed-dev  ## the whole test suite
	$(BIN)/python -m pytest -n $(WORKERS) --dist worksteal

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

format: $(VENV)/.installed-dev
	$(BIN)/ruff check --fix .
	$(BIN)/ruff format .

types: $(VENV)/.installed-dev
	$(BIN)/pyright

build: $(VENV)/.installed-dev  ## wheel, then a smoke test of it in isolation
	$(PIP) build
	rm -rf build dist && $(BIN)/python -m build --wheel --outdir dist .
	$(PIP) --no-deps --target dist/installed dist/*.whl
	cd dist && PYTHONPATH=installed $(abspath $(BIN))/python -P -c "import assets_cache, generator.cli; \
	  from generator.compose import compose; assert 'installed' in assets_cache.__file__; \
	  assert not any(assets_cache.verify().values()); assert len(assets_cache.find('starter')) >= 12; \
	  assert compose('a desk with a mug').report.passed"

clean:
	rm -rf $(VENV) build dist out *.egg-info .pytest_cache .ruff_cache
