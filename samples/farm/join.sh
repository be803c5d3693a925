#!/bin/sh
# Makes one film of the shares that the tasks of a job array encoded (film.sh with FPS set). Nothing is encoded again.
#
#   FPS=25 samples/farm/join.sh DIR SHARES OUT.mp4
set -eu
[ $# -eq 3 ] || { echo "usage: FPS=25 join.sh DIR SHARES OUT.mp4" >&2; exit 2; }
folder=$1 shares=$2 film=$3
"${CLAQUE:-claque}" frames check "$folder" >&2
parts=''
share=0
while [ "$share" -lt "$shares" ]; do
    part="$folder/share-$share.h264"
    [ -e "$part" ] || { echo "join.sh: share $share is not encoded: $part is not there" >&2; exit 1; }
    parts="$parts $share"
    share=$((share + 1))
done
for share in $parts; do cat "$folder/share-$share.h264"; done |
    ffmpeg -loglevel error -nostats -y -f h264 -framerate "${FPS:?set FPS as for film.sh}" -i - -c copy \
        -movflags +faststart -f mp4 "$film.part"
mv "$film.part" "$film"
