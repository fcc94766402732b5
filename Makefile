# Each target installs what it needs first: Debian packages (with sudo unless root), .venv and the build.
.PHONY: demo test lint format docs stubs bench bench-install wheel asan tsan fuzz clean

demo:  ## plan the example, check it, write demo/: plan.json, slide.png, slide.html
	@tools/install view,timing
	@.venv/bin/graspless example slide --output demo/
	@echo "the command is .venv/bin/graspless; more: .venv/bin/graspless example --list"

test:  ## C++ and Python tests
	@tools/install test,all GRASPLESS_TESTS=ON
	@tools/install-bench
	@.venv/bin/pip install --quiet --no-deps "airo-models>=0.0.12" "example-robot-data>=6" "rtb-data>=2"  # robots for tests: data alone
	ctest --test-dir build/make --output-on-failure --no-tests=error --parallel "$$(nproc)"
	@tools/test-ros
	.venv/bin/pytest --numprocesses=logical --maxprocesses=8 --dist=loadfile

lint:  ## what a commit must pass: ruff, mypy, clang-format, codespell
	@tools/install lint,all
	@tools/lint

format:
	@tools/install lint
	@tools/lint --fix

docs:  ## the documentation site, in build/docs; a warning or a broken link is an error
	@tools/install docs,all
	@tools/docs

stubs:  ## what is made from the extensions: *.pyi, the schemas, the page of options
	@tools/install test
	@tools/install-bench
	.venv/bin/python tools/stubs.py .
	.venv/bin/python tools/schema.py
	.venv/bin/python tools/options_page.py

bench-install:  ## the command `graspless bench`: the papers' experiments, and the planners to compare with
	@tools/install view,sim,batch,cluster
	@tools/install-bench

bench: bench-install  ## the papers' experiments anew, into docs/results: half an hour, and hours of physics
	@tools/results

wheel:  ## a wheel in wheelhouse/ that needs no Debian library, tested with those hidden
	@tools/install wheel
	@tools/build-wheel
	@tools/test-wheel wheelhouse/*.whl

asan tsan:  ## the tests under address and undefined-behaviour sanitizers, leaks included; under the thread sanitizer
	@tools/install test,all GRASPLESS_TESTS=ON
	@tools/sanitize $@

fuzz:  ## mutated input for every reader and planner: a fixed set, two minutes; or for a time: make fuzz HOURS=1
	@tools/install test,fuzz,all
	@tools/fuzz $(if $(HOURS),--hours $(HOURS))

clean:
	rm -rf build dist wheelhouse demo .venv
