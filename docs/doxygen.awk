# Our comments as Doxygen wants them: of the file, before a declaration, or after a member on its line. What it would take for
# a command or a tag is plain text here. Functions that share the comment of the one before say so, and those that fill in the
# struct before.
function plain(text) {
    gsub(/[@\\#%<>&]/, "\\\\&", text)
    return text
}
function comment(text) {
    inside = text !~ /\*\//
    before = struct = ""
    print plain(text)
}
NR == 1 && /^\/\*/ {
    printf "/** \\file\n *"
    comment(substr($0, 3))
    next
}
inside {
    comment($0)
    next
}
/\/\*/ {
    at = index($0, "/*")
    code = substr($0, 1, at - 1)
    printf "%s/**%s", code, code ~ /^ *$/ ? "" : "<"
    comment(substr($0, at + 2))
    next
}
/^static inline .*_init\(void\)/ { print "/** The values that are taken where nothing else is said. */" }
/^CLQ_API / && struct != "" { printf "/** Fills in %s, whose members say what. Fails: ARGUMENT; STALE_ID where an id is taken. */\n", struct }
/^CLQ_API / && before ~ /\);$/ { print "/** Goes with the function before, whose rules it follows. */" }
{
    if (/^} clq_[a-z_]+;$/) struct = substr($2, 1, length($2) - 1)
    else if (!/^$/) struct = ""
    before = $0
    print
}
