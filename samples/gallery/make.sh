#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Updates the thumbnails of the README and the sheet of variations: all of them, or the given ones. Uses the program
# that samples/quickstart.sh builds, or the program given by $FOAMTEX.
#
#     samples/gallery/make.sh
#     samples/gallery/make.sh lava sea_ice
#     samples/gallery/make.sh variations portraits letters
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

foamtex=${FOAMTEX:-$foamtex}
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# The most typical frame of a preset, if it is not frame 1.
declare -A frames=([coarsening]=30 [collapse]=24 [honeycomb]=40 [relax]=2 [shear]=49 [soap_raft]=30)

# thumbnail PRESET: bakes the first map of a preset at twice the size of the thumbnail, replaces transparency by white,
# and reduces the picture by half.
thumbnail() {
    local preset=$1 map
    map=$("$foamtex" presets show "$preset" | sed -nE 's/^maps = \["([a-z_]+)".*/\1/p')
    "$foamtex" bake "$preset" --frames "${frames[$preset]:-1}" --size 512 --maps "${map:-albedo}" -q \
        --out "$scratch/$preset.png"
    convert "$scratch/$preset.png" -background white -flatten -colorspace RGB -filter Box -resize 50% -colorspace sRGB \
        -quality 88 -strip "samples/gallery/$preset.jpg"
}

# variations: draws a sheet of random variations.
variations() {
    "$foamtex" vary dragon_skin --random 12 --width 190 -q --out "$scratch"
    convert "$scratch/dragon_skin_variations.png" -quality 88 -strip samples/gallery/variations.jpg
}

# letters: bakes the word of samples/letters, whose outline is a drawing.
letters() {
    "$foamtex" bake samples/letters/letters.toml -q --out "$scratch/letters.png"
    convert "$scratch/letters.png" -background white -flatten -colorspace RGB -filter Box -resize 50% -colorspace sRGB \
        -quality 88 -strip samples/gallery/letters.jpg
}

# portraits: bakes the portrait and the mosaic of samples/portrait, side by side.
portraits() {
    local preset
    for preset in portrait mosaic; do
        "$foamtex" bake "samples/portrait/$preset.toml" --frames 1 -q --out "$scratch/$preset.png"
    done
    convert "$scratch/portrait.png" "$scratch/mosaic.png" +append -colorspace RGB -filter Box -resize 50% \
        -colorspace sRGB -quality 88 -strip samples/gallery/portraits.jpg
}

ensure_packages imagemagick
[[ -x $foamtex ]] || build_foamtex
mapfile -t pictures < <("$foamtex" presets list | cut -d ' ' -f 1)
pictures+=(variations portraits letters)
for picture in "${@:-${pictures[@]}}"; do
    case $picture in
        variations | portraits | letters) "$picture" ;;
        *) thumbnail "$picture" ;;
    esac
done
