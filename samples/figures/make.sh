#!/usr/bin/env bash
# Makes the pictures of the READMEs anew, with the program of samples/quickstart.sh.
#
#     samples/figures/make.sh
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

foamtex=build/quickstart/texgen/foamtex
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# The first frame of a preset, tiled 2 x 2, at a size in pixels a tile.
tiled() {
    local preset=$1 size=$2
    "$foamtex" bake "$preset" --frames 1 --size "$size" --out "$scratch/$preset.png" -q
    montage "$scratch/$preset.png" "$scratch/$preset.png" "$scratch/$preset.png" "$scratch/$preset.png" \
        -tile 2x2 -geometry +0+0 -strip "samples/figures/${preset}_tiled.png"
}

ensure_packages "${foam_build_packages[@]}" imagemagick
[[ -x $foamtex ]] || samples/quickstart.sh --frames 1 --size 256
tiled sea_foam 400
