#!/bin/sh
# few_parts.sh JOBS: builds the command without any optional part (cmake/parts.cmake) and demands that each subcommand
# that is left out names the package to install.
set -eu
cd "$(dirname "$0")/../.."
build=build/few
off=$(sed -n 's/^ *claque_part(\([A-Z][A-Z]*\) .*/-DCLAQUE_WITH_\1=OFF/p; s/^.*"\([A-Z0-9]*\)|.*/-DCLAQUE_WITH_\1=OFF/p' \
    cmake/parts.cmake)
# shellcheck disable=SC2086  # a word for each part
cmake -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCLAQUE_TESTS=OFF -DCLAQUE_BENCHMARKS=OFF $off >$build.log
cmake --build $build -j "$1" --target claque_cli >>$build.log || { tail -n 20 $build.log >&2; exit 1; }
claque=$build/samples/claque
$claque --version
refused() {
    package=$1
    shift
    if said=$("$@" 2>&1); then
        echo "'$*' is not refused" >&2
        exit 1
    fi
    case "$said" in *"$package"*) ;; *) echo "'$*' does not name $package: $said" >&2; exit 1 ;; esac
}
refused librecast-dev $claque stage samples/scenarios/market.toml
refused librecast-dev $claque bench doors
refused libimgui-dev $claque view citizen
refused libassimp-dev $claque convert tests/bare/few_parts.sh --out $build/none.glb
echo "$(echo "$off" | wc -l) parts are left out, and the command names those that are asked for"
