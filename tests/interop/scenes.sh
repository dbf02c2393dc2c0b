#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads scene files of foamtex with programs of others: OpenUSD with @kroxilon/usda-parser, MaterialX with xmllint and with
# MaterialX itself (compiled to WebAssembly), glTF with its validator. See scenes/check.mjs.
# Usage: tests/interop/scenes.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

program=$(realpath -- "${1:-$(dirname -- "${BASH_SOURCE[0]}")/../../build/ci/texgen/foamtex}")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh
skip_without node xmllint tests/interop/scenes

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# bake FOLDER PRESET OPTION...: bakes two frames with the scene files $scenes into the folder.
scenes=usda,mtlx,gltf
bake() {
    local folder=$1
    shift
    "$program" bake "$@" --frames 1-3x2 --size 64x32 --scene "$scenes" -q --threads 1 \
        --set foam.bubbles=24 --set frames.count=4 --set frames.warm_up=0 --set height.full=0.5
    say "baked $folder"
}

for profile in unreal unity-hdrp unity-urp godot gltf blender; do
    bake "$profile" lava --for "$profile" --set output.sheets=none --out "$scratch/$profile/{map}/{preset}.####.png"
done
bake lit sea_foam --maps lit,normal --out "$scratch/lit/{map}.####.png"
bake patch soap_raft --maps albedo,height,normal --out "$scratch/patch/{map}.####.png"
bake lit_patch soap_raft --maps lit --out "$scratch/lit_patch/{map}.####.png"
bake exr lava --maps albedo,normal,height,roughness --normal-y dx --out "$scratch/exr/{map}.####.exr"
scenes=mtlx,gltf bake exr_patch soap_raft --maps albedo,normal --out "$scratch/exr_patch/{map}.####.exr"
bake packed lava --maps normal_dx --pack BCR=albedo.R,albedo.G,albedo.B,1-roughness \
    --pack H:16=1-height,occlusion,1-metallic --out "$scratch/packed/{map}.####.png"
bake height lava --maps height --out "$scratch/height/{map}.####.png"
bake varying coarsening --maps albedo,height --set relief.mean_bubble=current --out "$scratch/varying/{map}.####.png"
name="2nd & <\"foam's\">"
sed 's/^description = .*/description = "\\"quotes\\", <tags> \& @paths@"/' presets/lava.toml >"$scratch/$name.toml"
bake names "$scratch/$name.toml" --maps albedo --out "$scratch/names/a&b {preset}.####.png"

for document in "$scratch"/*/*.mtlx; do
    xmllint --noout --nonet "$document"
done
node tests/interop/scenes/check.mjs "$scratch"
say "all scene files were read"
