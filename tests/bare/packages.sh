#!/bin/sh
# packages.sh FOLDER   installs the .deb files of FOLDER on a bare Debian, that of SUITE (bookworm), and runs the
#                      command there, at last with OpenGL.
# The bare Debian is debootstrap's smallest, in a folder of its own. Needs root, debootstrap and Debian's archive.
set -eu
packages=$1
for command in debootstrap unshare chroot; do
    command -v $command > /dev/null || { echo "$0 needs $command" >&2; exit 1; }
done
[ "$(id -u)" = 0 ] || { echo "$0 needs root" >&2; exit 1; }

source=$(cd "$(dirname "$0")/../.." && pwd)
bare=$(mktemp -d)
chmod 755 "$bare"
trap 'rm -rf "$bare"' EXIT
debootstrap --variant=minbase "${SUITE:-bookworm}" "$bare" > "$bare.log" || { tail "$bare.log" >&2; exit 1; }
rm -f "$bare.log"
cp /etc/resolv.conf "$bare/etc/"
for file in /etc/apt/apt.conf.d/*proxy*; do [ ! -e "$file" ] || cp "$file" "$bare/etc/apt/apt.conf.d/"; done

mkdir "$bare/packages"
cp "$packages"/*.deb "$bare/packages"
cp "$source/tests/embed/strip_host.c" "$source/tests/golden/strip_host.txt" "$bare/"
cat > "$bare/try.sh" << 'end'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
install() { apt-get install -y -qq --no-install-recommends "$@" > /install.log 2>&1 || { tail /install.log; exit 1; }; }
apt-get update -qq
install /packages/libclaque*[0-9]_*.deb /packages/claque_*.deb /packages/claque-people_*.deb
claque --version
claque inspect citizen > /citizen.txt
head -n 3 /citizen.txt
ls /usr/share/applications/claque.desktop /usr/share/icons/hicolor/256x256/apps/claque.png
[ ! -e /packages/osgdb-claque*.deb ] || dpkg -c /packages/osgdb-claque*.deb | grep /osgPlugins-
install libegl1 libgl1-mesa-dri
claque render --scene plaza --count 50 --size 320x240 --out /plaza.png
ls -l /plaza.png
install gcc libc6-dev pkg-config /packages/libclaque-dev*.deb
cc -std=c99 /strip_host.c $(pkg-config --cflags --libs claque) -o /strip_host
/strip_host | diff /strip_host.txt -
echo "installed and run on Debian $(cat /etc/debian_version)"
end

# Mounts end with the namespace.
unshare -m sh -c 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && chroot "$0" sh /try.sh' "$bare"
