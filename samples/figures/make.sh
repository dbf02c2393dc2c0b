#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Updates the pictures and diagrams of this folder: all of them, or the given ones. Uses the program that
# samples/quickstart.sh builds, or the program given by $FOAMTEX.
#
#     samples/figures/make.sh
#     samples/figures/make.sh figure_4 figure_7
#     samples/figures/make.sh half_edges
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh

foamtex=${FOAMTEX:-$foamtex}
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# run_foamtex ARGUMENT...: runs the program. Builds it first if it does not exist.
run_foamtex() {
    [[ -x $foamtex ]] || build_foamtex
    "$foamtex" "$@"
}

# frames PRESET RANGE SIZE [OPTION]...: bakes frames of a preset into the scratch folder, SIZE x SIZE pixels each.
# Options are passed to `foamtex bake`.
frames() {
    local preset=$1 range=$2 size=$3
    shift 3
    run_foamtex bake "$preset" --frames "$range" --size "$size" --out "$scratch/$preset.####.png" -q "$@"
}

# sheet PRESET COLUMNS PICTURE: joins the baked frames of a preset, on white, in rows of COLUMNS frames.
sheet() {
    local preset=$1 columns=$2 picture=$3
    montage "$scratch/$preset".*.png -background white -tile "${columns}x" -geometry +6+6 -strip \
        "samples/figures/$picture.png"
}

sea_foam_tiled() {
    frames sea_foam 1 400
    local tile=$scratch/sea_foam.0001.png
    montage "$tile" "$tile" "$tile" "$tile" -tile 2x2 -geometry +0+0 -strip samples/figures/sea_foam_tiled.png
}

figure_4() {
    frames relax 1-2 480
    sheet relax 2 figure_4
}

figure_6() {
    frames coarsening 1,33,65,96 480 --set foam.domain=patch
    sheet coarsening 2 figure_6
}

figure_7() {
    frames collapse 4-124x24 320
    sheet collapse 3 figure_7
}

figure_8() {
    frames labyrinth 1 960
    convert "$scratch/labyrinth.0001.png" -strip samples/figures/figure_8.png
}

shear() {
    frames shear 1-145x48 320
    sheet shear 4 shear
}

soap_raft() {
    frames soap_raft 1-91x30 320
    sheet soap_raft 4 soap_raft
}

maze() {
    run_foamtex bake maze --maps maze_solution --frames 1 --set foam.bubbles=300 --set output.texts=left-out \
        --out "$scratch/maze.svg" -q
    cp -- "$scratch/maze.svg" samples/figures/maze.svg
}

studio() {
    ensure_npm tests/browser
    ensure_packages chromium
    [[ -x $foamtex ]] || build_foamtex
    mkdir "$scratch/folder"
    FOAMTEX=$foamtex node samples/figures/studio.mjs "$scratch/folder" "$scratch/studio.png"
    convert "$scratch/studio.png" -quality 90 -strip samples/figures/studio.jpg
}

# states NAME PRESET RANGE [OPTION]...: simulates frames of a preset and stores their states in $scratch/NAME, from
# which diagrams read them. Options are passed to `foamtex simulate`.
states() {
    local name=$1 preset=$2 range=$3
    shift 3
    run_foamtex simulate "$preset" --frames "$range" --cache "$scratch/$name" -q "$@"
}

diagram() {
    python3 -B samples/figures/diagrams --states "$scratch" "$1"
}

t1_and_t2() {
    states shear shear 20,74,75 --set foam.bubbles=60 --set foam.area_ratio=3
    states coarsening coarsening 1,16,22 --seed 6 --set foam.domain=torus --set foam.bubbles=150 \
        --set frames.time_step=1 --set frames.step_growth=1
    diagram t1_and_t2
}

half_edges() {
    states torus sea_foam 1 --seed 4 --set foam.bubbles=9 --set foam.lloyd=3 --set foam.area_ratio=0
    diagram half_edges
}

ghost_bubble() {
    states patch soap_raft 1 --seed 8 --set foam.bubbles=10 --set dynamics.kappa=0
    diagram ghost_bubble
}

film_arc() { diagram film_arc; }
signed_area() { diagram signed_area; }
bake_flow() { diagram bake_flow; }
rooms() { diagram rooms; }

pictures=(sea_foam_tiled figure_4 figure_6 figure_7 figure_8 shear soap_raft maze studio)
diagrams=(t1_and_t2 half_edges ghost_bubble film_arc signed_area bake_flow rooms)
figures=("${pictures[@]}" "${diagrams[@]}")
for figure in "$@"; do
    if [[ " ${figures[*]} " != *" $figure "* ]]; then
        echo "samples/figures/make.sh: no figure '$figure'; there are ${figures[*]}" >&2
        exit 2
    fi
done
ensure_packages imagemagick python3
for figure in "${@:-${figures[@]}}"; do
    "$figure"
done
