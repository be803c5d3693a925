#!/bin/sh
# foreign.sh i386|arm64|mingw|nehalem [JOBS]: builds libclaque for another machine and runs its tests that need no
# OpenGL and no files. Nehalem is an emulated processor of 2008, without AVX and AVX2.
set -eu
cd "$(dirname "$0")/.."
preset=$1 jobs=${2:-$(nproc)}

# Names missing tools and their packages; a missing tool is no failure.
missing=''
need() { command -v "$1" > /dev/null || missing="$missing $2"; }
case $preset in
    i386) need i686-linux-gnu-g++ g++-i686-linux-gnu ;;
    arm64)
        need aarch64-linux-gnu-g++ g++-aarch64-linux-gnu
        need qemu-aarch64 qemu-user ;;
    mingw)
        need x86_64-w64-mingw32-g++-posix g++-mingw-w64-x86-64-posix
        need wine 'wine wine64' ;;
    nehalem)
        [ "$(uname -m)" = x86_64 ] || { echo "skipped: test-nehalem needs an x86-64 processor"; exit 0; }
        need qemu-x86_64 qemu-user ;;
    *)
        echo "foreign.sh: $preset is none of i386, arm64, mingw, nehalem" >&2
        exit 2 ;;
esac
[ -d /usr/src/googletest ] || missing="$missing googletest"
if [ -n "$missing" ]; then
    echo "skipped: test-$preset needs$missing (apt-get install --no-install-recommends$missing)"
    exit 0
fi

# What a build for another machine cannot have, and tests that are left out of it, for the table of machines.py.
left_out() { echo "left out: $1"; }
left_out "libclaque-assets, samples, hosts, pictures: they need libraries not built for this machine"

if [ "$preset" = mingw ]; then  # a Wine prefix of its own, silent, set up before the first test is timed
    WINEPREFIX=$PWD/build/mingw/wine WINEDEBUG=-all
    export WINEPREFIX WINEDEBUG
    mkdir -p "$WINEPREFIX"
    wine wineboot --init > build/mingw/wineboot.log 2>&1
fi
if [ "$preset" = arm64 ] || [ "$preset" = nehalem ]; then
    # QEMU takes some 30 times as long for floating point. Long series are left out of which the same suite has shorter
    # ones.
    set -f
    left=''
    for name in Reach.NoVertexOfAHundredThousandPoses* TemplateFile.ChangedWithAForgedHash* Cover.IsExactlyTheTexels* \
        PeriodLaw.RatesReached* PeriodLaw.NoFrameCarries* BudgetLaw.AnyNumberOfThreads* LiveLaw.ActorsStepBack* \
        KeyPoseLaw.ThePictureDoesNotDependOn* AllocationLaw.ActorsThatComeIntoView* Fuzz.CallsAtRandomKeepToTheLaws; do
        left="$left:$name"
        left_out "$name: takes minutes under QEMU; the other tests of ${name%%.*} run"
    done
    set +f
    export GTEST_FILTER="-${left#:}"
fi
mkdir -p build
cmake --preset "$preset" > "build/$preset.log" 2>&1 || { cat "build/$preset.log"; exit 1; }
cmake --build --preset "$preset" -j "$jobs"
ctest --preset "$preset" -j "$jobs"
