# Verbs over the CMake presets. `make run` and `make test` do everything on a bare Debian.
PRESET ?= release
LONG_TESTS = ON
BUILD = build/$(PRESET)
JOBS ?= $(shell nproc)
CLAQUE = $(BUILD)/samples/claque
PICTURES = $(BUILD)/samples/claque-pictures

.PHONY: help setup build command run video test ci ci-all test-asan test-tsan test-scalar test-threads \
    test-mutants test-random fuzz faults soak bench golden-accept abi-accept installed install package test-package test-bare \
    test-few test-hosts docs test-i386 test-arm64 test-mingw test-nehalem test-machines test-webgl test-gl \
    test-guest nightly release test-queues test-bits test-reproducible wheel test-wheel coverage check format clean

help:
	@echo "make run        install what is missing, build, render the odeon into out/"
	@echo "make command    the claque command alone, with all its subcommands"
	@echo "make video      the odeon along its camera path as out/odeon.mp4 (needs ffmpeg)"
	@echo "make test       install what is missing, build, run all tests but the longest, which make ci runs"
	@echo "make ci         make test, the long tests too, then readers, C API and corpora under sanitizers (ci-all: all of CI, 70 minutes at most)"
	@echo "make nightly    the checks that take too long for CI, for hours, with one table at the end (STEPS='faults soak': some)"
	@echo "make release    checks version, changelog and tree, runs the tests; sources, wheel, .debs and sums into out/release"
	@echo "make test-mutants  changes the code on purpose and demands that a test sees it (MUTANTS='cull/*': some)"
	@echo "make test-random  300 changes of random statements, by the hash of the last commit; names those that no test sees (DRAW='--count 30 --area lib/track': others)"
	@echo "make fuzz       libFuzzer over every reader and the C API, SECONDS=20 each (tests/fuzz; needs clang)"
	@echo "make faults     each allocation of each call of the C API fails, at every place that allocates (an hour)"
	@echo "make soak       a million updates of a changing crowd, then films whose processes are killed, random input and malformed viewers of the window (some minutes)"
	@echo "make test-queues  doors and corridors with five seeds, tests of RiMEA with one (four minutes)"
	@echo "make test-threads  the tests of what the headers say about threads, under ThreadSanitizer"
	@echo "make test-bits  the hashes of tests/bits by GCC and clang, as Release and with -O1 (COMPILERS='g++-13': others)"
	@echo "make test-asan  the same tests under AddressSanitizer and UBSan (also test-tsan, test-scalar)"
	@echo "make bench      figures: the odeon, key-poses, ten thousand, the plaza, the sky, growth, the cost model, skinning, poses"
	@echo "make check      formatting, warnings as errors, layers, names in the docs"
	@echo "make install    into PREFIX (default /usr/local), DESTDIR respected"
	@echo "make package    Debian packages into out/packages (make test-package: lintian, and a trial on a bare Debian 12 or SUITE; needs root)"
	@echo "make wheel      the Python module, the libraries and the command as one file in out/wheel, on Debian 12 (make test-wheel: tries it on bare Debian 12, 13 and testing; needs root)"
	@echo "make test-reproducible  two builds of the last commit in different folders give the same bytes"
	@echo "make test-bare  each command of the README on bare Debian systems (SUITES='bookworm trixie forky'; needs root)"
	@echo "make test-few   the command without its optional parts, each of which names the package that it lacks"
	@echo "make test-hosts claque in sumo-gui, osgviewer, Coin and VTK on a screen of its own; what is missing is named"
	@echo "make docs       the reference of the headers into out/reference (needs doxygen)"
	@echo "make test-i386  libclaque on 32-bit x86 (also test-arm64 and test-nehalem under QEMU, test-mingw under Wine)"
	@echo "make test-machines  all four, with one table at the end"
	@echo "make test-webgl  a WebGL renderer (three.js in Chromium) against the CPU path, with one table at the end (needs chromium, nodejs, npm)"
	@echo "make test-gl    zone law, guard and pictures on every OpenGL that is installed, with one table (MESA=FOLDER: others too)"
	@echo "make test-guest a crowd in a corner of glxgears, etr, gltron and TORCS, which may change nothing else (PROGRAMS: some)"
	@echo "make coverage   lines and branches of the library that its tests run, held to 95 % and 90 % (needs gcovr)"

setup:
	@cmake/setup.sh

CONFIGURE = mkdir -p build && { cmake --preset $(PRESET) $(1) > build/$(PRESET).log 2>&1 || { cat build/$(PRESET).log; exit 1; }; }

build: setup
	@$(call CONFIGURE,-DCLAQUE_TESTS=ON -DCLAQUE_BENCHMARKS=ON -DCLAQUE_LONG_TESTS=$(LONG_TESTS))
	@cmake --build --preset $(PRESET) -j $(JOBS)

# No test, no benchmark and no host, if they are not part of the build already.
CONFIGURE_FEW = if [ -e $(BUILD)/build.ninja ]; then $(call CONFIGURE,); \
    else $(call CONFIGURE,-DCLAQUE_TESTS=OFF -DCLAQUE_BENCHMARKS=OFF); fi
BUILD_FEW = cmake --build --preset $(PRESET) -j $(JOBS) --target

# The claque command alone.
command:
	@set -e; cmake/setup.sh command; $(CONFIGURE_FEW); $(BUILD_FEW) claque_cli

# The subcommands that draw pictures, which need fewer packages.
run:
	@set -e; cmake/setup.sh run; [ -e $(BUILD)/build.ninja ] || { $(CONFIGURE_FEW); }; $(BUILD_FEW) claque_pictures
	@mkdir -p out
	$(PICTURES) render --scene odeon --size 1024x768 --out out/odeon.png --json out/odeon.json
	$(PICTURES) render --scene odeon --size 1024x768 --camera close --out out/odeon-close.png
	$(PICTURES) sheet --scene odeon --size 640x480 --out out/odeon-sheet.png
	$(PICTURES) variety patrician --out out/odeon-variety.png
	$(PICTURES) render --scene town_sky --count 6000 --size 1024x768 --out out/town-sky.png
	@ls -l out

# Frames go straight into the encoder; the film is there once it is whole.
video: command
	@command -v ffmpeg > /dev/null || { echo "make video needs ffmpeg: apt-get install ffmpeg" >&2; exit 1; }
	@mkdir -p out
	@rm -f out/odeon.part.mp4 out/odeon.failed
	{ $(CLAQUE) render --scene odeon --frames all --size 1024x768 --out - || touch out/odeon.failed; } | \
	    ffmpeg -loglevel error -nostats -y -f rawvideo -pix_fmt rgb24 -s 1024x768 -r 25 -i - \
	    -c:v libx264 -crf 21 -preset fast -pix_fmt yuv420p -movflags +faststart out/odeon.part.mp4
	@if [ -e out/odeon.failed ]; then rm -f out/odeon.failed out/odeon.part.mp4; exit 1; fi
	@mv out/odeon.part.mp4 out/odeon.mp4
	@ls -l out/odeon.mp4

# Without the long tests: readers counted block by block, parity, packages, pictures of levels, figures and the odeon,
# pictures by Mesa's reference rasteriser, visibility by rays, the evening, reaches of figures and characters, each
# allocation and each operation on a file that fails, each kind of file that is none, signals and processes of the
# command, each widget of the window, and settings under which bits are the same.
test: LONG_TESTS = OFF
test: build
	ctest --preset $(PRESET) -j $(JOBS)

# make build, the plain suite, then the readers, the C API and the fuzz corpora under ASan and UBSan, and one summary;
# ci-all also runs test-threads, runs each fuzzer for 20 s and tries ten random mutants.
ci:
	@cmake/ci.sh $(BUILD) $(JOBS)

ci-all:
	@cmake/ci.sh $(BUILD) $(JOBS) all

# The checks that seldom fail and take long, one after the other; each is a target of this file.
nightly:
	@cmake/nightly.sh $(JOBS) $(STEPS)

# CONTRIBUTING.md says how a release is made.
release:
	@cmake/release.sh

test-asan test-tsan test-scalar: test-%:
	@$(MAKE) --no-print-directory build PRESET=$*
	ctest --preset $* -j $(JOBS)

# The tests of what the headers say about threads (tests/abi/threads.txt), under ThreadSanitizer.
test-threads: setup
	@cmake/threads.sh $(JOBS) out/threads.log

# Each compiler makes the same bits.
test-bits:
	@cmake/setup.sh bits
	@tests/bits/compilers.sh $(JOBS) $(COMPILERS)

# The rows of docs/navigation.md. One of five seeds misses those of the narrowest door and of stops in counterflow.
test-queues: build
	CLAQUE_QUEUE_SEEDS=5 $(BUILD)/tests/unit/walk/queues_test

# tests/mutants/README.md
test-random: setup
	@tests/mutants/random.py --jobs $(JOBS) $(or $(DRAW),--count 300)

test-mutants: setup
	@tests/mutants/run.py --jobs $(JOBS) $(MUTANTS)

# What ctest tries in brief (tests/faults).
faults: build
	CLAQUE_FAULTS=thorough $(BUILD)/tests/faults/memory_faults_test

soak: build
	$(BUILD)/tests/soak/soak --updates 1000000 --seconds 1700
	tests/cli/killed_films.py $(BUILD)/samples/claque
	[ ! -x $(BUILD)/tests/view/view_serve_test ] || CLAQUE_VIEW_MESSAGES=200000 $(BUILD)/tests/view/view_serve_test --gtest_filter='MalformedMessages.*'
	[ ! -x $(BUILD)/tests/view/view_test ] || CLAQUE_VIEW_EVENTS=20000 CLAQUE_VIEW_SIDE=8192 $(BUILD)/tests/view/view_test --gtest_filter='RandomInput.*'

# tests/fuzz/README.md
SECONDS ?= 20
fuzz:
	@cmake/setup.sh fuzz || true
	@JOBS=$(JOBS) tests/fuzz/run.py $(SECONDS) $(FUZZERS)

bench: build
	@cmake --build --preset $(PRESET) -j $(JOBS) --target claque_benchmarks
	$(BUILD)/tests/bench/claque_micro_bench --benchmark_repetitions=3 --benchmark_report_aggregates_only=true
	$(BUILD)/tests/bench/claque_impostor_bench
	$(BUILD)/tests/bench/claque_draw_bench
	$(BUILD)/tests/bench/claque_startup_bench --benchmark_repetitions=3 --benchmark_report_aggregates_only=true
	$(BUILD)/tests/bench/claque_stage_bench
	$(BUILD)/tests/bench/claque_neighbours_bench
	$(BUILD)/tests/bench/claque_scene_bench
	$(BUILD)/tests/bench/claque_record_bench
	@mkdir -p out
	$(CLAQUE) bench odeon --lod off,on --save out/odeon-bench.json
	$(CLAQUE) plot out/odeon-bench.json --out out/odeon-bench.svg
	$(CLAQUE) bench odeon --strategy fused --cache none,animation,full,keypose-intermittent,keypose-interpolated --save out/odeon-keyposes.json
	$(CLAQUE) plot out/odeon-keyposes.json --out out/odeon-keyposes.svg
	$(CLAQUE) bench ten_thousand --cache full --strategy fused --context egl --flush 16384 --save out/ten-thousand.json
	$(CLAQUE) plot out/ten-thousand.json --out out/ten-thousand.svg
	$(CLAQUE) bench plaza
	$(CLAQUE) bench tracks
	$(CLAQUE) bench town_sky --count 2000,6000 --threads 1
	$(CLAQUE) bench hundred_actors --threads 1 --operations out/hundred-counts.json
	$(CLAQUE) cost --measured out/hundred-counts.json --plot out/cost.svg > out/cost.txt
	$(CLAQUE) bench million --save out/million.json
	$(CLAQUE) plot out/million.json --out out/million.svg
	$(CLAQUE) bench million-memory --save out/million-memory.json
	$(CLAQUE) plot out/million-memory.json --out out/million-memory.svg
	$(CLAQUE) bench amphitheatre --count 50000 --cache full --strategy fused --context egl --flush 16384
	$(CLAQUE) bench growth --threads 1 --save out/growth.json
	$(CLAQUE) plot out/growth.json --out out/growth.svg
	$(BUILD)/tests/parity/parity_fig11 --save out/parity-fig11.json
	$(CLAQUE) plot out/parity-fig11.json --out out/parity-fig11.svg

golden-accept: build
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene plaza --lod off --count 400 --size 320x240 --time 1.5 --out tests/golden/plaza.png
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene plaza --lod off --count 400 --camera close --size 320x240 --time 1.5 --out tests/golden/plaza-close.png
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene odeon --lod off --size 320x240 --time 1.5 --out tests/golden/odeon.png
	GALLIUM_DRIVER=softpipe $(CLAQUE) render --scene odeon --lod off --camera close --size 320x240 --time 1.5 --out tests/golden/odeon-close.png
	GALLIUM_DRIVER=softpipe $(CLAQUE) view patrician --lod off --count 2 --size 640x720 --script tests/golden/window.toml --shots tests/golden
	$(BUILD)/tests/embed/strip_host > tests/golden/strip_host.txt
	$(BUILD)/tests/bits/claque_bits > tests/bits/expected.txt

# What the shared libraries export and import now is what they may.
abi-accept: build
	tests/abi/list.sh $(BUILD)/lib/api/libclaque.so > tests/abi/libclaque.abi
	tests/abi/list.sh $(BUILD)/lib/api/assets/libclaque-assets.so > tests/abi/libclaque-assets.abi
	tests/abi/list.sh $(BUILD)/lib/stage/libclaque-stage.so > tests/abi/libclaque-stage.abi

# All that is installed.
installed:
	@set -e; cmake/setup.sh command; $(CONFIGURE_FEW); $(BUILD_FEW) claque_installed

install: installed
	@cmake --install $(BUILD) --prefix $(or $(PREFIX),/usr/local)

# What each depends on is asked of dpkg-shlibdeps. Times in the packages are those of the last commit.
package: build
	@command -v dpkg-shlibdeps > /dev/null || { echo "make package needs dpkg-shlibdeps: apt-get install dpkg-dev" >&2; exit 1; }
	@mkdir -p out
	@seconds=$${SOURCE_DATE_EPOCH:-$$(git log -1 --format=%ct 2> /dev/null)}; \
	    [ -z "$$seconds" ] || export SOURCE_DATE_EPOCH=$$seconds; umask 022; \
	    CLAQUE_DEB_COMPRESSION=xz cpack --config $(BUILD)/CPackConfig.cmake -B out/packages > out/packages.log 2>&1 || { cat out/packages.log; exit 1; }
	@ls -l out/packages/*.deb

# What make package makes: by the rules of Debian, and on a bare Debian 12. SUITE=trixie: of a build on Debian 13.
test-package: package
	@command -v lintian > /dev/null || { echo "make test-package needs lintian: apt-get install lintian" >&2; exit 1; }
	@lintian --allow-root --fail-on error,warning out/packages/*.deb
	@tests/bare/packages.sh out/packages

test-reproducible: setup
	@tests/reproducible.sh build/reproducible $(JOBS)

# The wheel's tag promises glibc 2.36 and the libstdc++ of GCC 12, which are those of Debian 12.
wheel: PRESET = wheel
wheel:
	@. /etc/os-release; [ "$$ID$$VERSION_ID-$$(uname -m)" = debian12-x86_64 ] || { echo "make wheel needs Debian 12 on x86-64, as wheels run on systems no older than theirs; this is $$PRETTY_NAME, $$(uname -m)" >&2; exit 1; }
	@cmake/setup.sh wheel
	@$(call CONFIGURE)
	@cmake --build --preset wheel -j $(JOBS) --target claque claque-assets claque-stage claque_cli claque_mpi claque_manual claque_people
	@rm -rf out/wheel
	@cmake/wheel/make.py $(BUILD) out/wheel
	@tests/wheel/check.py out/wheel/*.whl

# SUITES="bookworm trixie forky": those tried.
test-wheel: wheel
	@tests/wheel/bare.py out/wheel/*.whl

# The commands of the README on bare Debian systems, held to their times (two idle cores; needs root).
SUITES ?= bookworm trixie forky
test-bare:
	@tests/bare/run.py $(SUITES)

# The command without its optional parts: each names the package that it lacks.
test-few: setup
	@tests/bare/few_parts.sh $(JOBS)

# Programs and scenegraphs that claque knows nothing of; each is skipped by name where it is not installed.
test-hosts: build
	@tests/hosts/strangers.py $(BUILD) out/hosts

# The reference of include/claque; a warning is an error.
docs:
	@docs/doxygen.sh out/reference

# libclaque for other machines, with those of its tests that need no OpenGL; what is missing here is skipped by name.
test-i386 test-arm64 test-mingw test-nehalem: test-%: setup
	@tests/foreign.sh $* $(JOBS)

# All of them, with one table at the end; what is missing here is named in it.
test-machines: setup
	@tests/machines.py --jobs $(JOBS)

# A WebGL renderer written from docs/parity.md, in Chromium (tests/parity/webgl). CASES='odeon plaza': some.
test-webgl: command
	@tests/parity/webgl/test.py $(CLAQUE) build/webgl out/webgl $(CASES)

# Each implementation of OpenGL that is here, and those of the unpacked packages in the folders of MESA (tests/drivers).
test-gl: build
	@tests/drivers/run.py --build $(BUILD) $(if $(MESA),--mesa $(MESA)) $(DRIVERS)

# Programs that know nothing of claque, recorded and replayed with a crowd in a corner (tests/guest).
test-guest: build
	@tests/guest/run.py --build $(BUILD) $(PROGRAMS)

# Lines and branches of the library that its tests run, folder by folder.
coverage:
	@cmake/setup.sh coverage
	@$(MAKE) --no-print-directory build PRESET=coverage
	@tests/coverage.py --jobs $(JOBS)

# Each version of clang-format breaks some lines elsewhere.
CLANG_FORMAT = $(firstword $(shell command -v clang-format-14 clang-format))

check: setup
	@if $(CLANG_FORMAT) --version | grep -q 'version 14\.'; then \
	    $(CLANG_FORMAT) --dry-run -Werror $$(git ls-files '*.h' '*.hpp' '*.c' '*.cpp'); \
	else echo "make check: the format of sources is not checked, as clang-format 14 is not installed" >&2; fi
	@$(MAKE) --no-print-directory build PRESET=dev
	@cmake --build --preset dev -j $(JOBS) --target claque_benchmarks
	ctest --preset dev -R '^(Layers|Style|Docs)'

format:
	@$(CLANG_FORMAT) --version | grep -q 'version 14\.' || { echo "make format needs clang-format 14" >&2; exit 1; }
	$(CLANG_FORMAT) -i $$(git ls-files '*.h' '*.hpp' '*.c' '*.cpp')

clean:
	rm -rf build out
