#!/bin/sh
# between_calls.sh FOLDER: prints a macro for each call that the headers of the folder declare (between.h), but for
# those by which a library takes its own settings.
set -eu
sed -n 's/^CLQ_API [^(]*\(clq_[a-z0-9_]*\)(.*/#define \1(...) between::call_of(\1, "\1")(__VA_ARGS__)/p' "$1"/*.h |
    grep -v clq_floats_
