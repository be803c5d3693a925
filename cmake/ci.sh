#!/bin/sh
# ci.sh BUILD JOBS [all]: runs `make build`, builds the benchmarks, tries three quick implementations of OpenGL
# (tests/drivers), runs every test of BUILD, then the tests labelled `bytes` in a build with AddressSanitizer and UBSan.
# With `all` it also runs the tests of threads under ThreadSanitizer (threads.sh), runs each fuzzer for 20 s where clang
# can be had (tests/fuzz) and tries ten random mutants of one area (tests/mutants); it names those that no test sees,
# and they are no failure. With `all` it ends within 70 minutes: the steps after the tests are ended or left out when
# the time is over, and nightly.sh has them. It ends with one summary in CTest's words of all runs of tests. Each line
# `ci: ...` names a step and the seconds since the beginning.
set -eu
build=$1
jobs=$2
extent=${3:-tests}
mkdir -p out
: >out/ci-sanitizers.log
: >out/ci-threads.log
failed=''
left_out=''
began=$(date +%s)
last_s=${LAST_S:-4140}

seconds() { echo $(($(date +%s) - began)); }
step() {
    name=$1
    echo "ci: $(seconds) s: $name"
}
# A step in the last twentieth of the time would show little.
in_time() {
    step "$1"
    [ "$extent" != all ] || [ "$(seconds)" -lt $((last_s * 19 / 20)) ] || {
        left_out="$left_out, $name"
        return 1
    }
}
# within COMMAND...: ends it when the time is over. That is told at the end, and no failure.
within() {
    [ "$extent" = all ] || {
        "$@"
        return
    }
    left_s=$((last_s - $(seconds)))
    timeout -k 10 $((left_s > 1 ? left_s : 1)) "$@" && return
    status=$?
    [ "$(seconds)" -ge "$last_s" ] || return $status
    left_out="$left_out, the rest of $name"
}
# quietly LOG COMMAND...: its output is shown if it fails.
quietly() {
    log=$1
    shift
    within "$@" >"$log" 2>&1 || {
        failed="$failed $(basename "$log" .log)"
        cat "$log"
    }
}

# Some machines forbid what a leak checker does, and a few what AddressSanitizer does: a program that does nothing
# tells.
sanitizers_run() {
    echo 'int main() { return 0; }' | c++ -fsanitize=address,undefined -x c++ - -o out/ci-nothing || return 0
    out/ci-nothing >out/ci-nothing.log 2>&1 && return 0
    cat out/ci-nothing.log
    if ASAN_OPTIONS=detect_leaks=0 out/ci-nothing; then
        echo "ci: no leak checker can run here; leaks are not looked for"
        export ASAN_OPTIONS=detect_leaks=0
    else
        echo "ci: AddressSanitizer cannot run here: skipped"
        return 1
    fi
}

step build
make --no-print-directory build JOBS="$jobs"
step benchmarks  # which must go on compiling
cmake --build "$build" -j "$jobs" --target claque_benchmarks
step drivers
quietly out/ci-drivers.log tests/drivers/run.py --build "$build" llvmpipe-256 llvmpipe-128 osmesa
step tests
ctest --test-dir "$build" -j "$jobs" --output-on-failure --output-log out/ci-tests.log || failed="$failed tests"
if in_time "readers, C API and corpora under ASan and UBSan" && sanitizers_run; then
    quietly out/ci-asan.log cmake --preset asan
    within cmake --build --preset asan -j "$jobs" --target claque_bytes_tests &&
        within ctest --test-dir build/asan -j "$jobs" -L '^bytes$' --no-tests=error --output-on-failure \
            --output-log out/ci-sanitizers.log || failed="$failed sanitizers"
fi
if [ "$extent" = all ] && in_time "threads under ThreadSanitizer"; then
    quietly out/ci-tsan.log cmake/threads.sh "$jobs" out/ci-threads.log
    tail -n 8 out/ci-tsan.log
fi
if [ "$extent" = all ] && in_time fuzzers; then
    cmake/setup.sh fuzz >out/ci-clang.log 2>&1 || true  # without root they may have to be skipped, and say so
    quietly out/ci-fuzz.log env JOBS="$jobs" tests/fuzz/run.py --seed 1 20
    tail -n 20 out/ci-fuzz.log
fi
if [ "$extent" = all ] && in_time mutants; then
    quietly out/ci-mutants.log tests/mutants/random.py --count 10 --area any --jobs "$jobs"
    tail -n 12 out/ci-mutants.log
fi
step end

results() { cat out/ci-tests.log out/ci-sanitizers.log out/ci-threads.log; }
count() { results | grep -cE "$1" || true; }
all=$(count '^ *[0-9]+/[0-9]+ Test +#[0-9]+: ')
skipped=$(count '^ *[0-9]+/[0-9]+ Test .*\*\*\*Skipped')
bad_words='\*\*\*(Failed|Exception|Timeout|Not Run)'
bad=$(count "^ *[0-9]+/[0-9]+ Test .*$bad_words")
# The end of a log is what people read first: it names what failed, and says the first reasons.
if [ "$bad" != 0 ]; then
    reasons=': Failure$|^(==[0-9]+==)?ERROR: |: runtime error: |^WARNING: ThreadSanitizer: '
    results | grep -E -A 5 "$reasons" | cut -c 1-160 | head -n 12
    results | grep -E "^ *[0-9]+/[0-9]+ Test .*$bad_words" |
        tr -s ' .' | cut -c 1-160 | head -n 6
fi
[ -z "$left_out" ] || echo "ci: 70 minutes are over, which leaves out ${left_out#, }; make nightly has them"
[ -z "$failed" ] || echo "failed:$failed"
echo "$((all - skipped - bad)) passed, $bad failed, $skipped skipped"
if [ "$bad" = 0 ]; then percent=100; else percent=$(((all - bad) * 100 / all)); fi
echo "$percent% tests passed, $bad tests failed out of $all"
[ -z "$failed" ] && [ "$bad" = 0 ]
