#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Makes the thumbnails of the README anew, one of each shipped preset, or of those named, with the program of
# samples/quickstart.sh or the one that $FOAMTEX names.
#
#     samples/gallery/make.sh
#     samples/gallery/make.sh lava sea_ice
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

foamtex=${FOAMTEX:-$foamtex}
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# The frame that shows best what a preset is about, where that is not the first.
declare -A frames=([coarsening]=9 [collapse]=24 [honeycomb]=40 [relax]=2 [shear]=49 [soap_raft]=30)

# The first of its maps, at twice the size of the thumbnail; what is transparent on white.
thumbnail() {
    local preset=$1 map
    map=$("$foamtex" presets show "$preset" | sed -nE 's/^maps = \["([a-z_]+)".*/\1/p')
    "$foamtex" bake "$preset" --frames "${frames[$preset]:-1}" --size 512 --maps "${map:-albedo}" -q \
        --out "$scratch/$preset.png"
    convert "$scratch/$preset.png" -background white -flatten -colorspace RGB -filter Box -resize 50% -colorspace sRGB \
        -quality 88 -strip "samples/gallery/$preset.jpg"
}

ensure_packages imagemagick
[[ -x $foamtex ]] || build_foamtex
mapfile -t presets < <("$foamtex" presets list | cut -d ' ' -f 1)
for preset in "${@:-${presets[@]}}"; do
    thumbnail "$preset"
done
