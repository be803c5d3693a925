#!/bin/sh
# list.sh LIBRARY: the symbols that a shared library exports and imports, as tests/abi/*.abi lists them. Those it
# imports have the version that they need; weak ones are those of the compiler's start-up code and unwinder.
set -eu
export LC_ALL=C
readelf -d "$1" | sed -n 's/.*(SONAME).*\[\(.*\)\]/soname \1/p; s/.*(NEEDED).*\[\(.*\)\]/needs \1/p' | sort
nm -D --defined-only -P "$1" | awk '{ print "exports", $1 }' | sort
nm -D --undefined-only -P "$1" | awk '{ print ($2 == "U" ? "imports" : "imports-weakly"), $1 }' | sort
