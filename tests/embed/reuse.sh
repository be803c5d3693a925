#!/bin/sh
# reuse.sh COMPILER ARGUMENT...: compiles, or takes the object from the build in CLAQUE_REUSE_BUILD if that was made
# from the same source by the same command line. Folders differ: here the library is a folder `claque` of another
# project.
set -eu
compile() { exec "$@"; }

object='' depends='' previous=''
for argument in "$@"; do
    case $previous in
        -o) object=$argument ;;
        -MF) depends=$argument ;;
    esac
    previous=$argument
done
ready=$CLAQUE_REUSE_BUILD/${object#claque/}
case $object in claque/*.o) ;; *) compile "$@" ;; esac
[ -f "$ready" ] || compile "$@"

# The command as the other build has it: its source tree, its build tree, its place of objects.
wanted=$(echo "$*" | sed -e "s|$HOME/build/claque|$CLAQUE_REUSE_BUILD|g" -e "s|$HOME/claque|$CLAQUE_REUSE_SOURCE|g" \
    -e "s| claque/| |g" -e 's| -M[DTF]\( [^ -][^ ]*\)\{0,1\}||g')
commands=$CLAQUE_REUSE_BUILD/compile_commands.json
if grep -qF -- "$wanted\"" "$commands" ||
    sed -e "s/ -Werror//" -e "s/ -DCLAQUE_SCALAR=1//" "$commands" | grep -qF -- "$wanted\""; then  # options of a preset
    cp "$ready" "$object"
    echo "$object:" > "$depends"
    exit 0
fi
compile "$@"
