#!/bin/sh
# Makes one film of the shares that the tasks of a job array encoded (film.sh with FPS set). Nothing is encoded again.
#
#   FPS=25 samples/farm/join.sh DIR SHARES OUT.mp4
set -eu
[ $# -eq 3 ] || { echo "usage: FPS=25 join.sh DIR SHARES OUT.mp4" >&2; exit 2; }
folder=$1 shares=$2 film=$3
"${CLAQUE:-claque}" frames check "$folder" >&2
each_share() { seq 0 $((shares - 1)); }
for share in $(each_share); do
    encoded="$folder/share-$share.h264"
    [ -e "$encoded" ] || { echo "join.sh: share $share is not encoded: $encoded is not there" >&2; exit 1; }
    # Its frames were drawn again, and the task that did so has not encoded them.
    [ "$encoded" -nt "$folder/share-$share.json" ] ||
        { echo "join.sh: share $share is not encoded: $encoded is older than its manifest" >&2; exit 1; }
done
for share in $(each_share); do cat "$folder/share-$share.h264"; done |
    ffmpeg -loglevel error -nostats -y -f h264 -framerate "${FPS:?set FPS as for film.sh}" -i - -c copy \
        -movflags +faststart -f mp4 "$film.part"
mv "$film.part" "$film"
