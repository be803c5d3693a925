#!/bin/sh
# ci.sh BUILD JOBS: builds the benchmarks, runs every test of BUILD, then those labelled `bytes` in a build with
# AddressSanitizer and UBSan, runs each fuzzer for 20 s where clang can be had (tests/fuzz), tries ten mutants
# (tests/mutants), tries the three quickest implementations of OpenGL (tests/drivers), and ends with one summary of the
# tests: N passed, N failed, N skipped.
set -eu
build=$1
jobs=$2
mkdir -p out
failed=0
cmake --build "$build" -j "$jobs" --target claque_benchmarks  # which must go on compiling
ctest --test-dir "$build" -j "$jobs" --output-on-failure --output-log out/ci-tests.log || failed=1
tests/drivers/run.py --build "$build" llvmpipe-256 llvmpipe-128 glx > out/ci-drivers.log 2>&1 || {
    failed=1
    cat out/ci-drivers.log
}
cmake --preset asan > build/asan.log 2>&1 || { cat build/asan.log; exit 1; }
cmake --build --preset asan -j "$jobs" --target claque_bytes_tests
ctest --test-dir build/asan -j "$jobs" -L '^bytes$' --no-tests=error --output-on-failure \
    --output-log out/ci-sanitizers.log || failed=1
cmake/setup.sh fuzz > out/ci-fuzz.log 2>&1 || true  # without root the fuzzers may have to be skipped
JOBS="$jobs" tests/fuzz/run.py 20 > out/ci-fuzz.log 2>&1 || failed=1
cat out/ci-fuzz.log
tests/mutants/run.py --some 10 --jobs "$jobs" > out/ci-mutants.log 2>&1 || { failed=1; cat out/ci-mutants.log; }

count() { cat out/ci-tests.log out/ci-sanitizers.log | grep -cE "$1" || true; }
skipped=$(count '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped')
bad=$(count '^ *[0-9]+/[0-9]+ Test .*\*\*\*(Failed|Exception|Timeout|Not Run)')
all=$(count '^ *[0-9]+/[0-9]+ Test +#[0-9]+: ')
[ "$failed" = 0 ] || [ "$bad" != 0 ] || bad=1
echo "$((all - skipped - bad)) passed, $bad failed, $skipped skipped"
exit "$failed"
