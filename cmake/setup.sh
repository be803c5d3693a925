#!/bin/sh
# setup.sh [run|fuzz|coverage]: installs the Debian packages that are missing: all, with `run` those that the claque
# command needs alone, with `fuzz` also those that the fuzzers need (tests/fuzz), with `coverage` also gcovr.
# Without root it prints the command to run as root.
set -eu

packages='
g++ cmake ninja-build make git pkg-config
libglm-dev libopenmesh-dev nlohmann-json3-dev libstb-dev
libtbb-dev libcli11-dev libpng-dev libmd-dev libtomlplusplus-dev
libcairo2-dev fonts-dejavu-core
libosmesa6 libegl1 libgl1-mesa-dri
'
[ "${1:-all}" = run ] || packages="$packages
clang-format libgtest-dev libbenchmark-dev
libdraco-dev libmeshoptimizer-dev libwebp-dev libassimp-dev
libexpat1-dev libsqlite3-dev zlib1g-dev librecast-dev
libopenmpi-dev openmpi-bin
xvfb xdotool libglut-dev libopenscenegraph-dev libimgui-dev libsdl2-dev libvncserver-dev
python3-numpy python3-pytest
"
[ "${1:-all}" != coverage ] || packages="$packages gcovr"
[ "${1:-all}" != fuzz ] || packages="$packages clang libclang-rt-14-dev"

missing=''
for package in $packages; do
    state=$(dpkg-query -W -f '${Status}' "$package" 2>/dev/null || true)
    [ "$state" = 'install ok installed' ] || missing="$missing $package"
done
mkdir -p build
[ -n "$missing" ] || exit 0

if ! command -v apt-get >/dev/null 2>&1; then
    echo "claque builds on Debian 12; these packages are missing:$missing" >&2
    exit 1
fi
if [ "$(id -u)" -eq 0 ]; then
    as_root=''
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
    as_root='sudo'
else
    echo "These packages are missing, and installing them needs root. Run:" >&2
    echo "    apt-get install --no-install-recommends$missing" >&2
    exit 1
fi
echo "installing:$missing"
$as_root apt-get update -qq
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >build/setup.log 2>&1 || {
    tail -n 20 build/setup.log >&2
    exit 1
}
