#!/bin/sh
# compilers.sh JOBS [COMPILER...]: builds claque_bits with each compiler (g++ and clang++), as Release and with -O1, and
# compares its lines with expected.txt, also without the processor's AVX2 and FMA. It ends with one table. The exit
# status is 1 unless all are there and equal.
set -eu
cd "$(dirname "$0")/../.."
jobs=$1
shift
[ $# -gt 0 ] || set -- g++ clang++
table='| compiler | options | lines of expected.txt |\n|---|---|---|\n'
status=0
for compiler in "$@"; do
    if ! command -v "$compiler" > /dev/null; then
        table="$table| $compiler | | not installed |\n"
        status=1
        continue
    fi
    version=$("$compiler" -dumpfullversion 2> /dev/null || "$compiler" -dumpversion)
    for options in Release -O1; do
        folder=build/bits/$compiler$options
        mkdir -p "$folder"
        case $options in
        Release) type='-DCMAKE_BUILD_TYPE=Release' ;;
        *) type="-DCMAKE_BUILD_TYPE=None -DCMAKE_C_FLAGS=$options -DCMAKE_CXX_FLAGS=$options" ;;
        esac
        result="not built: see $folder.log"
        # shellcheck disable=SC2086  # one or three options
        if { CXX=$compiler CC=$(echo "$compiler" | sed 's/clang++/clang/; s/g++/gcc/') cmake -S . -B "$folder" -G Ninja \
            -DCLAQUE_SAMPLES=OFF -DCLAQUE_BENCHMARKS=OFF $type &&
            cmake --build "$folder" -j "$jobs" --target tests/bits/all; } > "$folder.log" 2>&1; then
            result=equal
            ctest --test-dir "$folder" -R '^bits\.' --no-tests=error --output-on-failure >> "$folder.log" 2>&1 ||
                result="different: see $folder.log"
        fi
        [ "$result" = equal ] || status=1
        table="$table| $compiler $version | $options | $result |\n"
    done
done
printf "$table"
exit $status
