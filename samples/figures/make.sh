#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Makes the pictures of this folder anew, with the program of samples/quickstart.sh: all of them, or those named.
#
#     samples/figures/make.sh
#     samples/figures/make.sh figure_4 figure_7
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# Frames of a preset, each $size pixels wide, into the scratch folder; more options of bake may follow.
frames() {
    local preset=$1 range=$2 size=$3
    shift 3
    "$foamtex" bake "$preset" --frames "$range" --size "$size" --out "$scratch/$preset.####.png" -q "$@"
}

# The frames of a preset on white, so many in a row, as the picture of a name.
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

pictures=(sea_foam_tiled figure_4 figure_6 figure_7 figure_8 shear soap_raft)
for picture in "$@"; do
    if [[ " ${pictures[*]} " != *" $picture "* ]]; then
        echo "samples/figures/make.sh: no picture '$picture'; there are ${pictures[*]}" >&2
        exit 2
    fi
done
ensure_packages imagemagick
[[ -x $foamtex ]] || build_foamtex
for picture in "${@:-${pictures[@]}}"; do
    "$picture"
done
