# Verbs over the CMake presets. `make run` and `make test` do everything on a fresh Debian 12.
PRESET ?= release
BUILD = build/$(PRESET)
JOBS ?= $(shell nproc)
CLAQUE = $(BUILD)/samples/claque

.PHONY: help setup build run test test-asan test-tsan test-scalar bench golden-accept install check format clean

help:
	@echo "make run        install what is missing, build, render the plaza into out/"
	@echo "make test       install what is missing, build, run every test"
	@echo "make test-asan  the same tests under AddressSanitizer and UBSan (also test-tsan, test-scalar)"
	@echo "make bench      figures: caches by variety by number of people, skinning, poses"
	@echo "make check      formatting, warnings as errors, layers"
	@echo "make install    into PREFIX (default /usr/local), DESTDIR respected"

setup:
	@cmake/setup.sh

build: setup
	@mkdir -p build
	@cmake --preset $(PRESET) -DCMAKE_INSTALL_PREFIX=$(or $(PREFIX),/usr/local) > build/$(PRESET).log 2>&1 || { cat build/$(PRESET).log; exit 1; }
	@cmake --build --preset $(PRESET) -j $(JOBS)

run: build
	@mkdir -p out
	$(CLAQUE) render --scene plaza --count 400 --size 1024x768 --out out/crowd.png --json out/crowd.json
	$(CLAQUE) render --scene plaza --count 400 --size 1024x768 --camera close --out out/crowd-close.png
	@ls -l out

test: build
	ctest --preset $(PRESET) -j $(JOBS)

test-asan test-tsan test-scalar: test-%:
	@$(MAKE) --no-print-directory build PRESET=$*
	ctest --preset $* -j $(JOBS)

bench: build
	$(BUILD)/tests/bench/claque_micro_bench --benchmark_repetitions=3 --benchmark_report_aggregates_only=true
	$(CLAQUE) bench plaza

golden-accept: build
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene plaza --count 400 --size 320x240 --time 1.5 --out tests/golden/plaza.png
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene plaza --count 400 --camera close --size 320x240 --time 1.5 --out tests/golden/plaza-close.png

install: build
	@cmake --install $(BUILD)

check: setup
	@clang-format --dry-run -Werror $$(git ls-files '*.h' '*.hpp' '*.c' '*.cpp')
	@$(MAKE) --no-print-directory build PRESET=dev
	ctest --preset dev -R '^layers'

format:
	clang-format -i $$(git ls-files '*.h' '*.hpp' '*.c' '*.cpp')

clean:
	rm -rf build out
