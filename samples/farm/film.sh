#!/bin/sh
# Draws one share of a film: a task of a job array. Submitting the same array again draws only what is missing.
#
#   sbatch --array=0-39 samples/farm/film.sh DIR 40 0:499 --scene odeon          Slurm: 40 tasks
#   seq 0 39 | parallel CHUNK={} samples/farm/film.sh DIR 40 0:499 --scene odeon  GNU parallel on one machine
#   claque frames check DIR --frames 0:499                                        what is missing
#   samples/farm/join.sh DIR 40 film.mp4                                          one film of all shares
#
# film.sh DIR SHARES FRAMES [OPTIONS OF claque render]. CLAQUE names another program than `claque`. With FPS set, the
# task encodes its share as well (needs ffmpeg).
#SBATCH --cpus-per-task=1
set -eu
[ $# -ge 3 ] || { echo "usage: film.sh DIR SHARES FRAMES [OPTIONS OF claque render]" >&2; exit 2; }
share=${CHUNK:-${SLURM_ARRAY_TASK_ID:?set CHUNK, or submit this as a job array}}
folder=$1 shares=$2 frames=$3
shift 3
mkdir -p "$folder"
manifest="$folder/share-$share.json"
"${CLAQUE:-claque}" render "$@" --frames "$frames" --chunk "$share/$shares" \
    --manifest "$manifest" --out "$folder/f-%06d.png"
[ -n "${FPS:-}" ] || exit 0
encoded="$folder/share-$share.h264"
[ ! "$encoded" -nt "$manifest" ] || exit 0

# The files of the frames alone: what the film is about may name files too.
pictures() { sed -n '/^ "frames": \[/,/^ \]/s/^ *"file": "\(.*\)",*$/\1/p' "$manifest"; }

# A pipe tells only how its last command ended, so a picture that is gone is noticed before.
pictures | while read -r picture; do
    [ -r "$folder/$picture" ] || { echo "film.sh: $folder/$picture of $manifest cannot be read" >&2; exit 1; }
done
# Each share begins with a key frame and refers to no other; without B-frames its times follow from the order alone.
pictures | while read -r picture; do cat "$folder/$picture"; done |
    ffmpeg -loglevel error -nostats -y -f image2pipe -framerate "$FPS" -c:v png -i - \
        -c:v libx264 -crf 18 -preset fast -pix_fmt yuv420p -bf 0 -f h264 "$encoded.part"
mv "$encoded.part" "$encoded"
