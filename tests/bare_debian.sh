#!/bin/sh
# bare_debian.sh PACKAGES: installs the .deb files of a folder on a bare Debian 12 (debootstrap's smallest) below a folder of its own,
# and runs the command there, at last with OpenGL. Needs root, debootstrap and Debian's archive.
set -eu
packages=$1
for command in debootstrap unshare chroot; do
    command -v $command > /dev/null || { echo "skipped: test-package needs $command"; exit 0; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: test-package needs root"; exit 0; }

bare=$(mktemp -d)
chmod 755 "$bare"
trap 'rm -rf "$bare"' EXIT
debootstrap --variant=minbase bookworm "$bare" > "$bare.log" || { tail "$bare.log" >&2; exit 1; }
rm -f "$bare.log"
mkdir "$bare/packages"
cp "$packages"/*.deb "$bare/packages"
cp /etc/resolv.conf "$bare/etc/"
cat > "$bare/try.sh" <<'end'
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C
install() { apt-get install -y -qq --no-install-recommends "$@" > /install.log 2>&1 || { tail /install.log; exit 1; }; }
apt-get update -qq
install /packages/libclaque[0-9]*.deb /packages/libclaque-assets*.deb /packages/claque_*.deb
claque --version
claque inspect citizen > /citizen.txt
head -n 3 /citizen.txt
install libosmesa6
claque render --scene plaza --count 50 --size 320x240 --out /plaza.png
ls -l /plaza.png
install gcc libc6-dev pkg-config /packages/libclaque-dev*.deb
cc -std=c99 /strip_host.c $(pkg-config --cflags --libs claque) -o /strip_host
/strip_host | diff /strip_host.txt -
echo "installed and run on Debian $(cat /etc/debian_version)"
end
cp tests/embed/strip_host.c tests/golden/strip_host.txt "$bare/"
# Mounts end with the namespace.
unshare -m sh -c 'mount -t proc proc "$0/proc" && chroot "$0" sh /try.sh' "$bare"
