#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Compiles the shader as GLSL, and measures its blending of frames with bakes. Godot is not needed. Writes to out/godot/.
# Exits with 1 if the shader does not compile, or if, for lava or caustics, blending along the motion differs from the
# drawn frame by more than two thirds of what a cross-fade differs.
#
#     samples/godot/test.sh
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

sample=samples/godot
out=out/godot

# measure PRESET FRAMES: bakes a loop of FRAMES frames and one of twice as many, and prints the differences.
measure() {
    local folder=$out/$1$2
    "$foamtex" bake "$1" --size 256 --set "frames.count=$2" --maps albedo,motion -q \
        --out "$folder/coarse/{preset}_{map}.####.png"
    "$foamtex" bake "$1" --size 256 --set "frames.count=$(($2 * 2))" --maps albedo -q \
        --out "$folder/fine/{preset}_{map}.####.png"
    python3 "$sample/motion_blending.py" "$folder" "$1"
}

# check PRESET FRAMES: also fails if blending along the motion is not at least a third nearer than the cross-fade.
check() {
    local row
    row=$(measure "$@")
    echo "$row"
    awk -v row="$row" 'BEGIN { match(row, /cross-fade [0-9.]+/); fade = substr(row, RSTART + 11, RLENGTH - 11)
        match(row, /motion [0-9.]+/); exit !(substr(row, RSTART + 7, RLENGTH - 7) < fade * 2 / 3) }' ||
        die "blending along the motion is too far from the drawn frame: $row"
}

ensure_packages glslang-tools python3 python3-numpy imagemagick
python3 "$sample/to_glsl.py" | glslangValidator --stdin -S frag
say "the shader compiles as GLSL ES 3.20"
build_foamtex
check lava 24
check caustics 24
measure iridescent 24
measure pebbles 24
