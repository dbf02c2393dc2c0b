# SPDX-License-Identifier: Apache-2.0

# shellcheck shell=bash
# Bakes textures that several tests of this folder read. The script that sources this file is given the path of the program
# foamtex, by default that of the preset ci, and has the root of the checkout as its working directory afterwards.

program=$(realpath -- "${1:-$(dirname -- "${BASH_SOURCE[0]}")/../../build/ci/texgen/foamtex}")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null || exit
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh

scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

# bake FOLDER SUFFIX SIZE OPTION...: bakes maps of all kinds into the folder.
bake() {
    local folder=$1 suffix=$2 size=$3
    shift 3
    "$program" bake lava --size "$size" --maps albedo,normal,height,roughness,motion,id --pack ORM=occlusion,roughness,metallic \
        --pack wide:16=height,occlusion,1-height --out "$scratch/$folder/{map}.####$suffix" -q "$@"
}

# bake_transparent FOLDER SUFFIX SIZE OPTION...: bakes an image with alpha, transparent.SUFFIX, into the folder.
bake_transparent() {
    local folder=$1 suffix=$2 size=$3
    shift 3
    "$program" bake soap_raft --size "$size" --frames 1 --maps albedo --out "$scratch/$folder/transparent$suffix" -q "$@"
}

# bake_textures SIZE: bakes the frames 1, 33 and 65 of a loop of 96 frames into the folders png, dds and ktx2, frame 33 without
# block compression into plain_dds and plain_ktx2, arrays of the three frames into the folder array, and images with alpha.
bake_textures() {
    local suffix
    bake png .png "$1" --frames 1-65x32
    for suffix in dds ktx2; do
        bake "$suffix" ".$suffix" "$1" --frames 1-65x32
        bake "plain_$suffix" ".$suffix" "$1" --frames 33 --set output.block_compression=none
    done
    for suffix in png dds ktx2; do
        bake_transparent "$suffix" ".$suffix" "$1"
    done
    bake_transparent plain_dds .dds "$1" --set output.block_compression=none
    bake_transparent plain_ktx2 .ktx2 "$1" --set output.block_compression=none
    "$program" flipbook "$scratch/png" --preset lava --dds --out "$scratch/array" -q
    "$program" flipbook "$scratch/ktx2" --preset lava --ktx2 --out "$scratch/array" -q
}
