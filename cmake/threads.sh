#!/bin/sh
# threads.sh JOBS LOG: builds the tests of what the headers say about threads (tests/abi/threads.txt) with
# ThreadSanitizer and runs them. LOG gets CTest's output.
set -eu
jobs=$1
log=$2
mkdir -p out
: >"$log"
# Some kernels use the addresses that ThreadSanitizer needs: a program that does nothing tells.
echo 'int main() { return 0; }' | c++ -fsanitize=thread -x c++ - -o out/nothing-tsan
if ! out/nothing-tsan; then
    echo "threads.sh: ThreadSanitizer cannot run here: skipped"
    exit 0
fi
cmake --preset tsan
# shellcheck disable=SC2046  # a word for each program
cmake --build --preset tsan -j "$jobs" --target $(tests/abi/threads.py --targets)
ctest --test-dir build/tsan -j "$jobs" -R "$(tests/abi/threads.py --tests)" --no-tests=error --output-on-failure \
    --output-log "$log"
