# Every target makes its own virtual environment first; a second call finds it done.
#   make demo              the Panda robot from URDF to simulation
#   make test              linters, types, tests; make slow: the rest of those that take long
#   make bench             speed beside error and beside other programs, docs/performance; QUICK=1
#   make hard              every integrator on every hard case, docs/hard_cases.md
#   make browser           the page in Chromium; make picture: the pictures of the documents
#   make site              the documentation site in out/site, offline
#   make wheel             source archive and wheel in dist, checked as a package index wants them
#   make PYTHON=python3.12 choose the interpreter;  make test PYTEST_ARGS="tests/ir -x" choose tests

SHELL := /bin/bash
PYTHON ?= python3
VENV ?= .venv
PYTEST_ARGS ?=
# what the benchmark compares with and draws with, where they do not install together
PEERS := cmeel-boost cmeel-eigen pin example-robot-data casadi mujoco drake exudyn scikit-sundae pydy cython mpmath \
	matplotlib
# of each of the eight kinds of input
CASES ?= 13000
BIN := $(VENV)/bin
# bytecode is written when it is first needed
INSTALL := $(BIN)/python -m pip install --disable-pip-version-check --no-compile
# of what pip says: the packages, and the kernels while they are compiled
STEPS := ^ *(Collecting [[:alnum:]_.-]+|Installing collected packages|kernels: .*)
SOURCES := pyproject.toml setup.py $(wildcard src/cardan/runtime/calls/*.pyx src/cardan/runtime/calls/*.pxi) $(wildcard src/cardan/kernels/*.[ch] src/cardan/kernels/*/*.[ch] src/cardan/kernels/*/*/*.[ch])

.PHONY: help demo test tests slow bench hard lint types external fuzz wheel browser picture site clean

help:
	@sed -n '2,9s/^#   //p' Makefile

$(BIN)/python:
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "cardan needs Python 3.11 or newer; say make PYTHON=...")'
	@echo "A virtual environment in $(VENV)"
	@$(PYTHON) -m venv $(VENV)

# one stamp per set of extras: newer sources install again
$(VENV)/.installed-%: $(SOURCES) | $(BIN)/python
	@echo "cardan[$*] and the packages it needs; about a minute the first time"
	@PYTHONUNBUFFERED=1 $(INSTALL) --verbose --editable '.[$*]' 2>&1 | tee $(VENV)/install.log | \
		grep --line-buffered -oE '$(STEPS)'; \
		test $${PIPESTATUS[0]} = 0 || { cat $(VENV)/install.log; exit 1; }
	@touch $@

demo: $(VENV)/.installed-demo
	$(BIN)/cardan demo panda

lint: $(VENV)/.installed-test
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

types: $(VENV)/.installed-test
	$(BIN)/mypy

# types beside the tests: they leave one of two cores alone
test: lint
	+$(MAKE) --no-print-directory --jobs=2 types tests

tests: $(VENV)/.installed-test
	# two processes on two cores: no threads of theirs besides; the many that tests start
	# read bytecode whatever the user's settings; models are compiled in a third of the time;
	# files go in the order of their folders: the last ones are small
	CARDAN_OPTIMIZATION=0 OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE= \
		$(BIN)/python -m pytest -n 2 --dist loadfile --no-loadscope-reorder \
		-m 'not external and not slow' $(PYTEST_ARGS)

# what make test takes a spread of, and the documentation site
slow: $(VENV)/.installed-test $(VENV)/.installed-docs
	OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 $(BIN)/python -m pytest -n 2 --dist load \
		-m 'slow and not external' $(PYTEST_ARGS)

external: $(VENV)/.installed-test
	$(BIN)/python -m pytest -n 2 --dist load -m external tests/external

# scenes, robots and expressions by chance, all of them new
fuzz: $(VENV)/.installed-test
	CARDAN_FUZZ=$(CASES) $(BIN)/python -m pytest -n 2 --dist load tests/scene/test_scene_fuzz.py tests/scene/test_urdf_fuzz.py

# a peer that does not install here is named by the benchmark, not by pip
$(VENV)/.installed-bench: $(VENV)/.installed-test
	$(INSTALL) --quiet --editable '.[bench]' || for peer in $(PEERS); do $(INSTALL) --quiet $$peer || true; done
	@touch $@

# writes docs/performance, a page by each of these programs; QUICK=1 for a few rows and no page
BENCHMARKS = bench runs flexible_runs superelement_runs large_loops paths gradients python_calls profiles \
	starts all_figures
bench: $(VENV)/.installed-bench
	@rm -rf out/figures; failed=; for program in $(BENCHMARKS); do \
	  OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1 $(BIN)/python tests/benchmarks/$$program.py $(if $(QUICK),--quick) || \
	    failed="$$failed $$program"; \
	done; test -z "$$failed" || { echo "failed:$$failed"; exit 1; }

$(VENV)/.installed-browser: $(VENV)/.installed-test
	$(INSTALL) playwright
	@touch $@

# the page in Chromium; CHROMIUM names one that is not on the path
browser: $(VENV)/.installed-browser
	$(BIN)/python -m pytest tests/view/test_browser.py tests/view/test_browser_surfaces.py

# docs/page.png of the README, docs/mode.png, docs/link.png, docs/slider_crank.svg, docs/branches_*.svg
picture: $(VENV)/.installed-browser
	$(BIN)/python tests/view/picture.py
	$(BIN)/python tests/superelements/slider_crank.py
	$(BIN)/python tests/examples/page_pictures.py

# writes docs/hard_cases.md
hard: $(VENV)/.installed-test
	$(BIN)/python tests/hard/page.py

# pages, reference, theory, gallery with a run of every example; pictures where there is Chromium
site: $(VENV)/.installed-docs
	OPENBLAS_NUM_THREADS=1 $(BIN)/python docs/site/build_site.py out/site

# with the symbols of an old glibc, so that it runs on every Linux in use
wheel: $(BIN)/python
	$(INSTALL) --quiet build auditwheel abi3audit
	rm -rf dist
	CARDAN_GLIBC=2.17 $(BIN)/python -m build
	$(BIN)/auditwheel show dist/*.whl | grep manylinux_2_17
	$(BIN)/abi3audit --strict dist/*.whl

clean:
	rm -rf $(VENV) build dist out .mypy_cache .ruff_cache .pytest_cache .hypothesis
