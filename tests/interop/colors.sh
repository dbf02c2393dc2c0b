#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Compares EXR files with output.primaries = "acescg" with the color conversion of OpenImageIO and OpenColorIO.
# Usage: tests/interop/colors.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
# shellcheck source=samples/setup/packages.sh
source "$root/samples/setup/packages.sh"
# shellcheck source=samples/setup/node.sh
source "$root/samples/setup/node.sh"
skip_without openimageio-tools openexr
program=$(realpath -- "${1:-$root/build/ci/texgen/foamtex}")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch"

# bake NAME OPTION...: writes NAME_srgb.exr and NAME_acescg.exr.
bake() {
    local name=$1 primaries
    shift
    for primaries in srgb acescg; do
        "$program" bake "$@" --frames 1 -q --set "output.primaries=$primaries" --out "${name}_$primaries.exr"
    done
}

# check_colors NAME: the colors are those that OpenImageIO computes from the file with the primaries of sRGB. Both files
# store half floats, so that the colors of either have an error of up to 2^-12, and sums of three such colors a little more.
check_colors() {
    oiiotool --colorconfig "$root/tests/interop/colors.ocio" "$1_srgb.exr" --colorconvert lin_rec709 acescg \
        -d half -o "$1_expected.exr"
    idiff -fail 0.0005 -warn 0.0005 "$1_expected.exr" "$1_acescg.exr" ||
        die "$1: OpenImageIO computes other colors"
    ! idiff -q -fail 0.01 "$1_srgb.exr" "$1_acescg.exr" >/dev/null 2>&1 || die "$1: the colors were not converted"
    exrheader "$1_acescg.exr" | grep -A4 chromaticities >"$1.txt"
    grep -q 'red .*0\.713 0\.293' "$1.txt" && grep -q 'white .*0\.32168 0\.33767' "$1.txt" ||
        die "$1: the chromaticities are not those of AP1: $(cat "$1.txt")"
}

# The thin film has strong colors. The patch has an opacity, by which its colors are multiplied.
bake torus iridescent --size 128 --maps lit
check_colors torus
bake patch soap_raft --size 128 --maps albedo
check_colors patch

# In a file of several maps, only colors are converted.
bake layers lava --size 64 --maps albedo,height,normal,id
check_data() {
    local layer
    for layer in height.Y normal.X,normal.Y,normal.Z id.Y; do
        for primaries in srgb acescg; do
            oiiotool "layers_$primaries.exr" --ch "$layer" -o "data_$primaries.exr"
        done
        idiff -q -fail 0 "data_srgb.exr" "data_acescg.exr" || die "the layer $layer was converted"
    done
}
check_data
"$program" compare layers_srgb.exr layers_acescg.exr -q --fail 0.001 --warn 0.001 >/dev/null || die "compare does not convert colors"
say "OpenImageIO computes the same colors"
