#!/bin/sh
# bare_debian.sh packages FOLDER   installs the .deb files of FOLDER on a bare Debian, that of SUITE (bookworm), and
#                                  runs the command there, at last with OpenGL.
# bare_debian.sh clone             clones this repository there, runs `make run` and `make test`, and holds both to
#                                  their times, MAX_RUN_S (180) and MAX_TEST_S (900) seconds once packages are
#                                  installed, meant for two idle cores.
# The bare Debian is debootstrap's smallest, in a folder of its own. Needs root, debootstrap and Debian's archive.
set -eu
mode=${1:-}
case "$mode" in
packages) packages=$2 ;;
clone) ;;
*) sed -n '2,6s/^# //p' "$0" >&2; exit 2 ;;
esac
for command in debootstrap unshare chroot; do
    command -v $command > /dev/null || { echo "skipped: $0 needs $command"; exit 0; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: $0 needs root"; exit 0; }

source=$(cd "$(dirname "$0")/.." && pwd)
bare=$(mktemp -d)
chmod 755 "$bare"
trap 'rm -rf "$bare"' EXIT
debootstrap --variant=minbase "${SUITE:-bookworm}" "$bare" > "$bare.log" || { tail "$bare.log" >&2; exit 1; }
rm -f "$bare.log"
cp /etc/resolv.conf "$bare/etc/"
for file in /etc/apt/apt.conf.d/*proxy*; do [ ! -e "$file" ] || cp "$file" "$bare/etc/apt/apt.conf.d/"; done

packages_script() {
    mkdir "$bare/packages"
    cp "$packages"/*.deb "$bare/packages"
    cp "$source/tests/embed/strip_host.c" "$source/tests/golden/strip_host.txt" "$bare/"
    cat > "$bare/try.sh" << 'end'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
install() { apt-get install -y -qq --no-install-recommends "$@" > /install.log 2>&1 || { tail /install.log; exit 1; }; }
apt-get update -qq
install /packages/libclaque*[0-9]_*.deb /packages/claque_*.deb
claque --version
claque inspect citizen > /citizen.txt
head -n 3 /citizen.txt
ls /usr/share/applications/claque.desktop /usr/share/icons/hicolor/256x256/apps/claque.png
[ ! -e /packages/osgdb-claque*.deb ] || dpkg -c /packages/osgdb-claque*.deb | grep /osgPlugins-
install libosmesa6
claque render --scene plaza --count 50 --size 320x240 --out /plaza.png
ls -l /plaza.png
install gcc libc6-dev pkg-config /packages/libclaque-dev*.deb
cc -std=c99 /strip_host.c $(pkg-config --cflags --libs claque) -o /strip_host
/strip_host | diff /strip_host.txt -
echo "installed and run on Debian $(cat /etc/debian_version)"
end
}

clone_script() {
    git clone -q "$source" "$bare/claque"
    cat > "$bare/try.sh" << 'end'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
cd /claque
apt-get update -qq
apt-get install -y -qq --no-install-recommends make > /install.log 2>&1
timed() {
    begun=$(date +%s)
    "$@"
    seconds=$(($(date +%s) - begun))
}
cmake/setup.sh run
timed make run
run=$seconds
[ -s out/odeon.png ]
echo "make run: $run s"
cmake/setup.sh
timed make test
echo "make run: $run s (at most $MAX_RUN_S), make test: $seconds s (at most $MAX_TEST_S) on Debian $(cat /etc/debian_version)"
[ "$run" -le "$MAX_RUN_S" ] && [ "$seconds" -le "$MAX_TEST_S" ]
end
}

"${mode}_script"
export MAX_RUN_S="${MAX_RUN_S:-180}" MAX_TEST_S="${MAX_TEST_S:-900}"
# Mounts end with the namespace.
unshare -m sh -c 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && chroot "$0" sh /try.sh' "$bare"
