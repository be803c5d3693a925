#!/bin/sh
# rehearsed.sh SOURCE_DIR: fails and names each public function that no sample, host, command or Python module calls.
set -eu
cd "$1"

# Functions of the headers: the first clq_ name before a parenthesis after each CLQ_API, on one line or two.
declared=$(cat include/claque/*.h | sed -n '/^CLQ_API/{/(/!N;s/\n/ /;s/^[^(]*\b\(clq_[a-z0-9_]*\)(.*/\1/p}' | sort -u)
count=$(echo "$declared" | grep -c .)
found=$(cat include/claque/*.h | grep -c '^CLQ_API')
[ "$count" -eq "$found" ] || { echo "$found lines begin with CLQ_API, but $count names were read from them"; exit 1; }

# Names in code: not in comments.
called=$(find samples lib/python \( -name '*.c' -o -name '*.cpp' -o -name '*.h' -o -name '*.py' \) -exec cat {} + |
    sed 's|//.*||; s|/\*.*\*/||; /^ *\/\*/d; /^ *\* /d; /^ *#/d' | grep -oE '\bclq_[a-z0-9_]+' | sort -u)

missing=$(printf '%s\n%s\n%s\n' "$called" "$called" "$declared" | sort | uniq -u)
[ -z "$missing" ] || { echo 'no file of samples/ or lib/python calls'; echo "$missing" | sed 's/^/    /'; exit 1; }
echo "all $count public functions are called"
