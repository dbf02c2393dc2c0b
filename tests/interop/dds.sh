#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads files of foamtex with programs of others: DDS textures with Pillow, which decodes BC5 and BC7, and their headers
# with nvddsinfo. Usage: tests/interop/dds.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

# shellcheck source=tests/interop/textures.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/textures.sh"
skip_without libnvtt-bin python3-pil python3-numpy

/usr/bin/python3 tests/interop/dds.py "$program" "$scratch"

"$program" bake lava --frames 1-3 --size 64x32 --maps albedo,height --out "$scratch/array/{map}.####.png" -q
"$program" flipbook "$scratch/array" --dds -q
for expected in "albedo 99" "height 56"; do
    read -r map format <<<"$expected"
    info=$(nvddsinfo "$scratch/array/lava_array_$map.dds")
    for line in "Height: 32" "Width: 64" "Mipmap count: 7" "DXGI Format: $format" "Array size: 3"; do
        grep -qF -- "$line" <<<"$info" || die "nvddsinfo does not print '$line' for the array of $map: $info"
    done
    say "nvddsinfo reads the array of $map"
done
say "all files were read"
