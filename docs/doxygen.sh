#!/bin/sh
# doxygen.sh FOLDER: the reference of include/claque as HTML. Fails where Doxygen warns of anything, or a function says nothing;
# 77 where there is no doxygen.
set -eu
mkdir -p "$1"
CLAQUE_REFERENCE=$(cd "$1" && pwd)
cd "$(dirname "$0")/.."
if ! command -v doxygen > /dev/null; then
    echo "skipped: the reference needs doxygen (apt-get install --no-install-recommends doxygen)"
    exit 77
fi
export CLAQUE_REFERENCE
# Members whose names say it all need no comment, functions do; what has none is not reported while everything is extracted.
undocumented=$(CLAQUE_EXTRACT_ALL=NO CLAQUE_WARN_AS_ERROR=NO doxygen docs/Doxyfile 2>&1 |
    grep -v -E '(Compound [^ ]+|Member .*\((variable|typedef|enumeration|enumvalue|macro definition)\) .*) is not documented' || true)
if [ -n "$undocumented" ]; then
    echo "$undocumented" >&2
    exit 1
fi
CLAQUE_EXTRACT_ALL=YES CLAQUE_WARN_AS_ERROR=FAIL_ON_WARNINGS doxygen docs/Doxyfile
echo "$CLAQUE_REFERENCE/index.html"
