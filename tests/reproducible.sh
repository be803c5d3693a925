#!/bin/sh
# reproducible.sh FOLDER JOBS: builds the last commit twice, in folders of different length below FOLDER, with different
# times, time zones and modes of new files. What is installed, the packages and the wheel are to be equal to the byte.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd) jobs=$2
first=$folder/one second=$folder/another/and/longer
unset MAKEFLAGS MAKELEVEL MFLAGS DESTDIR
SOURCE_DATE_EPOCH=$(git -C "$source" log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# sh does not end a function at a failure whose caller asks for it.
built() {
    make="make --no-print-directory -o setup -o build -o installed JOBS=$jobs"
    cmake --preset release -DCLAQUE_TESTS=OFF -DCLAQUE_BENCHMARKS=OFF &&
        cmake --build --preset release -j "$jobs" &&
        $make install PREFIX=/usr DESTDIR="$PWD/out/installed" &&
        $make package &&
        if grep -q 'VERSION_ID="12"' /etc/os-release; then $make wheel; fi
}
grep -q 'VERSION_ID="12"' /etc/os-release || echo "the wheel is left out: it is made on Debian 12"
for tree in "$first" "$second"; do
    rm -rf "$tree"
    mkdir -p "$tree"
    git -C "$source" archive HEAD | tar -x -C "$tree"
done
(cd "$first" && umask 022 && built) > "$folder/first.log" 2>&1 || { tail "$folder/first.log" >&2; exit 1; }
export TZ=Asia/Tokyo
(cd "$second" && umask 027 && built) > "$folder/second.log" 2>&1 || { tail "$folder/second.log" >&2; exit 1; }

files() { find out/installed out/packages/*.deb out/wheel/*.whl \( -type f -o -type l \) 2> "$folder/absent.log" | sort; }
(cd "$first" && files) > "$folder/first.txt"
(cd "$second" && files) > "$folder/second.txt"
diff "$folder/first.txt" "$folder/second.txt" || { echo "the builds have different files"; exit 1; }
different=0
while read -r file; do
    if cmp -s "$first/$file" "$second/$file"; then says=equal; else says=different different=$((different + 1)); fi
    printf '%-9s %9d  %s\n' $says "$(stat -L -c %s "$first/$file")" "$file"
done < "$folder/first.txt"
echo "$(wc -l < "$folder/first.txt") files, $different of them different"
[ $different = 0 ]
