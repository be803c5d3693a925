#!/bin/sh
# mesa.sh FOLDER SUITE...: downloads the Mesa of other Debian suites (bullseye, bookworm-backports) and unpacks each
# into FOLDER/SUITE, for run.py --mesa FOLDER. Nothing is installed, and apt's own lists stay as they are.
set -eu
[ $# -ge 2 ] || { echo "mesa.sh: needs a folder and names of suites" >&2; exit 2; }
mkdir -p "$1"
folder=$(cd "$1" && pwd)
shift
site=$(apt-get indextargets --format '$(SITE)' 'Created-By: Packages' | grep -m 1 'debian$')
for suite; do
    own=$folder/.apt/$suite
    mkdir -p "$own/lists/partial" "$own/cache/archives/partial" "$own/debs"
    echo "deb [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] $site $suite main" > "$own/sources.list"
    options="-o Dir::Etc::sourcelist=$own/sources.list -o Dir::Etc::sourceparts=/dev/null -o Dir::State::lists=$own/lists
        -o Dir::State::status=/dev/null -o Dir::Cache=$own/cache -o APT::Sandbox::User=root -q"
    apt-get $options update > "$own/log"
    # What comes from this suite; from others the system has it.
    packages=''
    for package in libosmesa6 libegl-mesa0 libgl1-mesa-dri libglapi-mesa libgbm1 mesa-libgallium libllvm11 libffi7; do
        [ -z "$(apt-cache $options madison "$package")" ] || packages="$packages $package"
    done
    (cd "$own/debs" && apt-get $options download $packages >> "$own/log")
    for package in "$own"/debs/*.deb; do dpkg -x "$package" "$folder/$suite"; done
    echo "$folder/$suite: $packages"
done
