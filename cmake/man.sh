#!/bin/sh
# man.sh CLAQUE TEMPLATE: the manual page on standard output. Subcommands and options are asked of the command itself.
set -eu
claque=$1 template=$2

subcommands() {
    "$claque" --help | awk '/^Subcommands:/ { on = 1; next } on && /^  [a-z]/ { print $1 }'
}

# The help text of one subcommand as roff: what it does, then each argument with its lines joined.
section() {
    "$claque" "$1" --help | awk -v name="$1" '
        function roff(text) {
            gsub(/\\/, "\\e", text)
            gsub(/-/, "\\-", text)
            return text ~ /^[.'"'"']/ ? "\\&" text : text
        }
        function say() {
            if (term != "") printf ".TP\n.B %s\n%s\n", roff(term), roff(description == "" ? " " : description)
            term = description = ""
        }
        NR == 1 { printf ".SS claque %s\n%s\n.PP\n", name, roff($0); next }
        /^Usage: / { printf ".B %s\n", roff(substr($0, 8)); next }
        /^[A-Z][a-z]*:$/ { say(); next }
        /^  [^ ]/ {
            say()
            line = substr($0, 3)
            if (length(line) > 28 && substr(line, 27, 2) ~ / $/ && match(substr(line, 1, 28), / +$/)) {
                term = substr(line, 1, RSTART - 1)
                description = substr(line, 29)
            } else if (match(line, /  +/)) {
                term = substr(line, 1, RSTART - 1)
                description = substr(line, RSTART + RLENGTH)
            } else term = line
            next
        }
        /^                              / { sub(/^ +/, ""); description = description (description == "" ? "" : " ") $0 }
        END { say() }'
}

sed -e "s/@VERSION@/$("$claque" --version | awk '{ print $2 }')/" -e '/^@SUBCOMMANDS@$/,$d' "$template"
for name in $(subcommands); do section "$name"; done
sed -e '1,/^@SUBCOMMANDS@$/d' "$template"
