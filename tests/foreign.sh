#!/bin/sh
# foreign.sh i386|arm64|mingw [JOBS]: libclaque for another machine, and those of its tests that need no OpenGL and no files.
# foreign.sh nehalem: some tests of the build that is there, on a processor of 2008 that knows neither AVX nor AVX2.
set -eu
cd "$(dirname "$0")/.."
preset=$1 jobs=${2:-$(nproc)}

# What is missing is named, and the packages that bring it; that is no failure.
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
    nehalem) need qemu-x86_64 qemu-user ;;
    *)
        echo "foreign.sh: $preset is none of i386, arm64, mingw, nehalem" >&2
        exit 2 ;;
esac
[ -d /usr/src/googletest ] || missing="$missing googletest"
if [ -n "$missing" ]; then
    echo "skipped: test-$preset needs$missing (apt-get install --no-install-recommends$missing)"
    exit 0
fi

if [ "$preset" = nehalem ]; then
    emulated="qemu-x86_64 -cpu Nehalem build/${PRESET:-release}/tests"
    $emulated/embed/strip_host | diff tests/golden/strip_host.txt -
    for test in unit/skin/skin_test unit/animcache/animcache_test unit/frame/frame_test actors/actors_test api/api_test; do
        $emulated/$test --gtest_brief=1
    done
    $emulated/law/claque_law_test --gtest_brief=1 \
        --gtest_filter='FrameLaw.TheFrames*:FrameLaw.PackedVerticesAreTheSame*:KeyPoseLaw.WhatIsShown*'
    exit 0
fi

if [ "$preset" = mingw ]; then  # a Windows of its own, silent, and set up before the first test counts
    WINEPREFIX=$PWD/build/mingw/wine WINEDEBUG=-all
    export WINEPREFIX WINEDEBUG
    mkdir -p "$WINEPREFIX"
    wine wineboot --init > build/mingw/wineboot.log 2>&1
fi
if [ "$preset" = arm64 ]; then
    # QEMU takes some 30 times as long for floating point. Left out is what takes seconds without it and compares the library
    # with itself over long series: what a processor has to do with those is in the tests that remain.
    GTEST_FILTER="-Reach.NoVertexOfAHundredThousandPoses*:TemplateFile.ChangedWithAForgedHash*:Cover.IsExactlyTheTexels*"
    GTEST_FILTER="$GTEST_FILTER:PeriodLaw.RatesReached*:PeriodLaw.NoFrameCarries*:BudgetLaw.AnyNumberOfThreads*:LiveLaw.ActorsStepBack*"
    GTEST_FILTER="$GTEST_FILTER:KeyPoseLaw.ThePictureDoesNotDependOn*:AllocationLaw.ActorsThatComeIntoView*:Fuzz.CallsAtRandomKeepToTheLaws"
    export GTEST_FILTER
fi
cmake --preset "$preset" > "build/$preset.log" 2>&1 || { cat "build/$preset.log"; exit 1; }
cmake --build --preset "$preset" -j "$jobs"
ctest --preset "$preset" -j "$jobs"
