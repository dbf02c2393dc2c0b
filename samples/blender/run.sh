#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Bakes sea_foam and renders it with Blender into out/blender/. This takes two minutes, and installs Blender, a large package.
#
#     samples/blender/run.sh
#     FOAM_FIGURES=1 samples/blender/run.sh      also updates the pictures of the README
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

sample=samples/blender
out=out/blender

bake() {
    say "baking"
    "$foamtex" bake sea_foam --maps albedo,normal,height --frames 1 \
        --out "$out/tile/{preset}_{map}.####.png"
    "$foamtex" bake sea_foam --maps albedo --size 256 --out "$out/book/{preset}_{map}.####.png"
    "$foamtex" flipbook "$out/book" --gutter 4
}

# Checks that the pictures drawn from the sheet differ by at most 1 % from the pictures drawn from the files of the frames.
compare() {
    local picture
    for picture in "$out"/sheet.*.png; do
        "$foamtex" compare --warn 0.01 --fail 0.01 "$picture" "${picture/sheet./frame.}" >/dev/null ||
            die "$picture differs from the frame itself"
    done
    say "the flipbook shows what its frames show"
}

ensure_packages blender python3-numpy
build_foamtex
bake
say "rendering"
blender -b -noaudio --python-exit-code 1 -P "$sample/foam.py" -- "$out" | grep '^==>\|Saved'
compare
[[ -z ${FOAM_FIGURES:-} ]] || cp "$out"/{relief,tiles}.png "$sample/"
