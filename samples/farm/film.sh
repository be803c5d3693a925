#!/bin/sh
# Draws one share of a film: a task of a job array. Submitting the same array again draws only what is missing.
#
#   sbatch --array=0-39 samples/farm/film.sh DIR 40 0:499 --scene odeon          Slurm: 40 tasks
#   seq 0 39 | parallel CHUNK={} samples/farm/film.sh DIR 40 0:499 --scene odeon  GNU parallel on one machine
#   claque frames check DIR --frames 0:499                                        what is missing
#
# film.sh DIR SHARES FRAMES [OPTIONS OF claque render]. CLAQUE names another program than `claque`.
#SBATCH --cpus-per-task=1
set -eu
[ $# -ge 3 ] || { echo "usage: film.sh DIR SHARES FRAMES [OPTIONS OF claque render]" >&2; exit 2; }
share=${CHUNK:-${SLURM_ARRAY_TASK_ID:?set CHUNK, or submit this as a job array}}
folder=$1 shares=$2 frames=$3
shift 3
mkdir -p "$folder"
exec "${CLAQUE:-claque}" render "$@" --frames "$frames" --chunk "$share/$shares" \
    --manifest "$folder/share-$share.json" --out "$folder/f-%06d.png"
