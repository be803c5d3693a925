#!/bin/sh
# changelog.sh CHANGELOG.md VERSION MAINTAINER: its first section in the form of Debian's changelogs. A section without
# a date has that of the build.
set -eu
heading=$(sed -n 's/^## //p' "$1" | head -n 1)
case "${heading:?$1 has no section}" in
*' - '[0-9][0-9][0-9][0-9]-[0-9][0-9]-[0-9][0-9]) date=${heading##* } ;;
*) date=@${SOURCE_DATE_EPOCH:-$(date +%s)} ;;
esac
printf 'claque (%s) unstable; urgency=medium\n\n' "$2"
awk '
    function say() { if (item != "") print "  " item; item = "" }
    { gsub(/\*\*|\]\([^)]*\)|\[/, "") }
    /^## / { if (++sections == 2) exit; next }
    /^### / { say(); if (parts++) print ""; item = "[ " substr($0, 5) " ]"; next }
    /^- / { say(); item = "*" substr($0, 2); next }
    item != "" && /^ / { item = item substr($0, 2) }
    END { say() }' "$1" | fold -s -w 76 | sed 's/^\([^ ]\)/    \1/; s/ *$//'
printf '\n -- %s  %s\n' "$3" "$(LC_ALL=C date -u -R -d "$date")"
