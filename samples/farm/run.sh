#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Bakes a loop directly. Then renders it from a cache, by a Slurm array job and by GNU parallel if
# these are installed, and compares every file with the bake. The Slurm cluster must be able to
# access this folder; slurm_node.sh sets up such a cluster.
#
#     samples/farm/run.sh [WORK_FOLDER]
set -euo pipefail

here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" >/dev/null && pwd)
root=$here/../..
export FOAMTEX=${FOAMTEX:-$root/build/release/texgen/foamtex}
work=${1:-$(mktemp -d)}
mkdir -p -- "$work"
cd -- "$work"

readonly frames=24
readonly foam=(sea_foam --set "frames.count=$frames" --set foam.bubbles=500 --size 512)
readonly maps=(--maps 'albedo,height,normal,motion')

seconds() {
    local start=$EPOCHREALTIME
    "$@"
    awk -v a="$start" -v b="$EPOCHREALTIME" 'BEGIN { printf "%.1f s\n", b - a }'
}

same_as_bake() {
    local file count=0
    for file in bake/*.png; do
        cmp "$file" "$1/${file#bake/}"
        count=$((count + 1))
    done
    "$FOAMTEX" verify "$1" -q
    printf '%s: %d files, every one has the bytes of the bake, and verify holds\n' "$1" "$count"
}

printf 'bake: '
seconds "$FOAMTEX" bake "${foam[@]}" "${maps[@]}" --out 'bake/{map}.####.png' -q
printf 'simulate: '
seconds "$FOAMTEX" simulate "${foam[@]}" --cache cache -q

# Files contain the preset, which includes the file pattern. Files can be equal to those of the bake only if they have the
# same pattern. Therefore the pattern is unchanged, and the working folder differs.
mkdir -p slurm parallel
if command -v sbatch >/dev/null; then
    printf 'slurm, 4 tasks: '
    seconds sbatch --wait -Q --array=0-3 --chdir="$work/slurm" "$here/bake.slurm" "$work/cache" $frames \
        "${maps[@]}" --out 'bake/{map}.####.png'
    same_as_bake slurm/bake
fi
if command -v parallel >/dev/null; then
    printf 'GNU parallel, 4 jobs at a time: '
    (cd parallel && seconds parallel -j 4 "$FOAMTEX" render ../cache --frames '{}-24x6' --threads 1 -q \
        "${maps[@]}" --out "'bake/{map}.####.png'" ::: 1 2 3 4 5 6)
    same_as_bake parallel/bake
fi
