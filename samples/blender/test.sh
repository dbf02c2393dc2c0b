#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Bakes small images, and tests the add-on with them in Blender, without a window. Exits with 1 if a test fails. Installs
# Blender, a large package. Writes to out/blender/.
#
#     samples/blender/test.sh
#     FOAM_FIGURES=1 samples/blender/test.sh      also renders the pictures of the README
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

sample=samples/blender
out=out/blender
export BLENDER_USER_SCRIPTS=$root/$out/scripts  # the add-on is installed here, not for the user
export BLENDER_USER_CONFIG=$root/$out/config

# bake FOLDER OPTION...: bakes into PNG files with 256 x 256 pixels, unless options say otherwise.
bake() {
    local folder=$1
    shift
    "$foamtex" bake "$@" -q --out "$out/$folder/{preset}_{map}.####.${format:-png}"
}

bake_all() {
    local -a loop=(sea_foam --size 256 --set frames.count=8 --set height.full=0.08 --set lit.gloss=0)
    local -a sun=(--set lit.colors=albedo --set lit.gloss=0 --set lit.rim=0 --set lit.ambient=0 --set lit.windows=0
        --set lit.horizon=0 --set lit.glow=0)
    say "baking"
    bake loop "${loop[@]}" --maps albedo,normal,height,roughness,occlusion,lit
    "$foamtex" flipbook "$out/loop" --maps albedo,normal,height --gutter 4 -q
    bake part "${loop[@]}" --maps albedo,normal --frames 3-6 --normal-y dx
    format=exr bake float "${loop[@]}" --maps albedo,normal,height,roughness --frames 1-2
    "$foamtex" bake "${loop[@]}" --maps albedo,normal --frames 1 -q --out "$out/layers/layers.####.exr"
    bake raft soap_raft --size 256 --maps albedo,opacity --frames 1-2
    bake coarsening coarsening --size 64 --maps albedo,height --frames 1-4
    bake pebbles pebbles --size 256 --maps albedo,normal,height,roughness,lit --frames 1 "${sun[@]}"
}

run_blender() {
    blender -b -noaudio --factory-startup --python-exit-code 1 -P "$@" |
        grep -v '^Fra:\|^Saved: \|^ Time: \|^$\|^Blender quit'
}

draw_figures() {
    "$foamtex" bake sea_foam --maps albedo,normal,height --frames 1 -q --out "$out/tile/{preset}_{map}.####.png"
    run_blender "$sample/test/pictures.py" -- "$out"
    cp "$out"/{relief,tiles}.png "$sample/"
}

ensure_packages blender python3 python3-numpy
build_foamtex
rm -rf -- "$out"
bake_all
"$sample/zip.sh" "$out/foamtex_import.zip"
mkdir -p -- "$BLENDER_USER_SCRIPTS"/addons "$BLENDER_USER_CONFIG"
say "testing in Blender"
run_blender "$sample/test/run.py" -- "$out" "$foamtex" "$out/foamtex_import.zip"
[[ -z ${FOAM_FIGURES:-} ]] || draw_figures
