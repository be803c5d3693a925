#!/bin/sh
# style.sh SOURCE_DIR: holds what clang-format cannot: the folders of the top level, lines of at most 120 columns, names
# of tests.
set -eu
cd "$1"
bad=0
report() { [ -z "$2" ] || { echo "$1:"; echo "$2" | head -n 400 | sed 's/^/    /'; bad=1; }; }

# The top level belongs to the project's owner.
allowed=' .ci .clang-format .editorconfig .git .gitignore ARCHITECTURE.md CHANGELOG.md CMakeLists.txt CMakePresets.json CONTRIBUTING.md LICENSE Makefile README.md SECURITY.md animcache build cmake docs include lib meshsplit out passes samples tests '
found=''
for entry in $(ls -A); do
    case "$allowed" in *" $entry "*) ;; *) found="$found $entry" ;; esac
done
report 'these do not belong to the top level' "$found"
for entry in CMakeLists.txt Makefile animcache include lib meshsplit passes samples tests; do
    [ -e "$entry" ] || report 'the top level lacks' "$entry"
done

sources=$(find animcache include lib meshsplit passes samples tests \( -name '*.h' -o -name '*.cpp' -o -name '*.c' \) | sort)
report 'lines of more than 120 columns' "$(echo "$sources" | xargs awk 'length > 120 { print FILENAME ":" FNR }')"
scripts=$(find Makefile cmake lib tests samples \( -name Makefile -o -name '*.sh' -o -name '*.py' -o -name '*.cmake' -o -name CMakeLists.txt \) | sort)
report 'comments of scripts with more than 120 columns' \
    "$(echo "$scripts" | xargs awk 'length > 120 && /^ *#/ { print FILENAME ":" FNR }')"
report 'lines of Python with more than 120 columns' \
    "$(echo "$scripts" | grep '\.py$' | xargs awk 'length > 120 { print FILENAME ":" FNR }')"
report 'names of tests are sentences in CamelCase, suites too' \
    "$(echo "$sources" | xargs grep -nE '^(TYPED_)?TEST(_F|_P)?\((([a-z]|[A-Za-z0-9]+_)[A-Za-z0-9_]*, |[A-Za-z0-9_]+, ([a-z]|[A-Za-z0-9]+_))' || true)"
# The parser itself has no limit of depth, and its values are copied, compared and freed by recursion.
report 'JSON is read by samples/io/json.h or lib/asset/json_parse.cpp, which limit its depth' \
    "$(echo "$sources" | grep -v '^tests/\|^samples/io/json.h$' | xargs grep -nE '[Jj]son::parse\(' || true)"
# toml++ gives an empty optional for a number that a double cannot hold, and code that takes its value reads anything.
report 'numbers of TOML are read by lib/asset, lib/stage/machine and samples/io/toml_number.cpp alone' \
    "$(echo "$sources" | grep -v '/toml_number\.cpp$' |
        xargs grep -nE '(\.|->)value(_exact)?<|as_(integer|floating_point)\(|(node|entry|base)(\.|->)value_or\(' || true)"
missing=''
for preset in dev asan fuzz; do
    sed -n "/\"name\": \"$preset\", \"displayName\"/,/}}/p" CMakePresets.json | grep -q -- '-D_GLIBCXX_ASSERTIONS' ||
        missing="$missing $preset"
done
report 'presets whose libstdc++ does not look at what it is asked for: -D_GLIBCXX_ASSERTIONS' "$missing"
# Other processors and C libraries round these otherwise; GLM calls them.
libm='a?(sin|cos|tan)h?|atan2|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|hypot|[tl]gamma|erfc?'
glm='angle|angleAxis|eulerAngles|orientedAngle|perspective|rotate|rotation|slerp'
report 'functions whose bits differ between C libraries: lib/math/trig.h has them' \
    "$(echo "$sources" | grep '^\(animcache\|lib\|meshsplit\|passes\)/' |
        xargs grep -nE "std::($libm)[fl]?\(|glm::($libm|$glm)\(|(^|[^:.>_[:alnum:]])($libm)f\(" || true)"
exit $bad
