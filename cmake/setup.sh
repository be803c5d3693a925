#!/bin/sh
# setup.sh [GROUP]: installs the Debian packages that are missing. Groups: run (the pictures of `make run`), command
# (the claque command with all of its parts), all (default: tests, benchmarks and hosts too), fuzz, coverage and wheel
# (all, and what these need).
#
# Each line of `packages` has a group, a package (alternatives with |, the best first) and, for packages that claque can
# do without, what is left out. A suite that has none of the alternatives is told about in one line. Without root the
# command to run as root is printed.
set -eu
group=${1:-all}

packages='
run      g++
run      cmake
run      ninja-build
run      make
run      git
run      pkg-config
run      libglm-dev
run      libopenmesh-dev
run      nlohmann-json3-dev
run      libstb-dev
run      libtbb-dev
run      libcli11-dev
run      libpng-dev
run      libmd-dev
run      libtomlplusplus-dev
run      libcairo2-dev
run      fonts-dejavu-core
run      libosmesa6            | contexts of OSMesa; those of EGL serve
run      libegl1
run      libgl1-mesa-dri
command  libdraco-dev          | glTF compressed with Draco
command  libmeshoptimizer-dev  | glTF compressed with meshopt
command  libwebp-dev           | textures in WebP
command  libassimp-dev         | claque convert
command  libexpat1-dev         | trajectories in XML
command  libsqlite3-dev        | trajectories in databases
command  zlib1g-dev
command  librecast-dev         | people who find their way: claque stage
command  libimgui-dev          | the window of claque view
command  libsdl2-dev           | the window of claque view
command  libvncserver-dev      | claque view --serve
all      libopenmpi-dev        | claque under mpirun
all      openmpi-bin           | claque under mpirun
all      clang-format          | the format of sources, in make check and make format
all      libgtest-dev
all      libbenchmark-dev
all      xvfb                  | tests that need an X server
all      xdotool               | tests that press keys under X
all      libglut-dev           | samples/hosts/glut
all      libopenscenegraph-dev | samples/hosts/osg
all      python3-numpy         | tests of the Python module
all      python3-pytest        | tests of the Python module
bits     clang
fuzz     clang                 | fuzzers
fuzz     libclang-rt-14-dev|libclang-rt-dev | fuzzers
coverage gcovr
wheel    patchelf
'

# Each group has the one before it.
case $group in
run) groups=' run ' ;;
command) groups=' run command ' ;;
all) groups=' run command all ' ;;
bits | fuzz | coverage | wheel) groups=" run command all $group " ;;
*) echo "setup.sh: the groups are run, command, all, bits, fuzz, coverage and wheel" >&2; exit 2 ;;
esac

# Without apt's lists no package is offered; those that claque can do without are then not asked for.
missing='' needed='' absent=''
look() {
    missing='' needed='' absent=''
    names=$(echo "$packages" | awk -v groups="$groups" 'index(groups, " " $1 " ") { gsub(/\|/, " ", $2); print $2 }')
    # shellcheck disable=SC2016,SC2086  # dpkg's own variables; a word for each package
    installed=$(dpkg-query -W -f '${Package} ${Status}\n' $names 2>/dev/null | sed -n 's/ install ok installed$/ /p')
    # shellcheck disable=SC2086
    offered=$(apt-cache policy $names 2>/dev/null |
        awk '/^[^ ]/ { name = $1; sub(/:.*/, "", name) } $1 == "Candidate:" && $2 != "(none)" { print name " " }')
    while read -r in alternatives without; do
        case "$groups" in *" $in "*) ;; *) continue ;; esac
        found=''
        for package in $(echo "$alternatives" | tr '|' ' '); do
            case "
$installed" in *"
$package "*) continue 2 ;; esac
            case "
$offered" in *"
$package "*) found=${found:-$package} ;; esac
        done
        if [ -n "$found" ]; then
            missing="$missing $found"
        elif [ -z "$without" ]; then
            needed="$needed ${alternatives%%|*}"
        else
            absent="$absent
this suite has no ${alternatives%%|*}, so this is left out: ${without#| }"
        fi
    done <<end
$(echo "$packages" | grep .)
end
}

mkdir -p build
if ! command -v apt-get >/dev/null 2>&1; then
    echo "setup.sh: there is no apt-get: these packages of Debian have to be there:$(echo "$packages" | awk -v groups="$groups" \
        'NF && index(groups, " " $1 " ") { printf " %s", $2 }')" >&2
    exit 0
fi
if [ "$(id -u)" -eq 0 ]; then
    as_root=''
elif command -v sudo >/dev/null 2>&1 && sudo -n true 2>/dev/null; then
    as_root='sudo'
else
    as_root='none'
fi
look
# Lists are made anew before packages are fetched, and once to know what the suite lacks.
if [ "$as_root" != none ] && { [ -n "$missing$needed" ] || { [ -n "$absent" ] && [ ! -e build/setup.updated ]; }; }; then
    $as_root apt-get update -qq || [ -z "$missing$needed" ]  # without a network nothing may be needed
    touch build/setup.updated
    look
fi
[ -z "$absent" ] || echo "${absent#?}"
[ -n "$missing$needed" ] || exit 0

if [ "$as_root" = none ]; then
    echo "These packages are missing, and installing them needs root. Run:" >&2
    echo "    apt-get install --no-install-recommends$missing$needed" >&2
    exit 1
fi
[ -z "$needed" ] || { echo "setup.sh: this suite has no$needed, which claque needs" >&2; exit 1; }
echo "installing:$missing"
# shellcheck disable=SC2086  # a word for each package
DEBIAN_FRONTEND=noninteractive $as_root apt-get install -y -qq --no-install-recommends $missing >build/setup.log 2>&1 || {
    tail -n 20 build/setup.log >&2
    exit 1
}
