#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Bakes the same presets with several builds of foamtex, at each SIMD level, and with versions of the C library's
# functions for older processors, and checks that all pixels are the same.
#
#     tests/same_pixels.sh PRESET...       builds the programs of CMake presets first, for example
#                                          release plain clang_release clang: GCC with -O3 and -O0, Clang with -O2 and -O0
#     FOAM_RUNNER="qemu-aarch64 -L ..." tests/same_pixels.sh release aarch64
#
# FOAM_RUNNER runs all programs but the first one. The first program also compares the pictures.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

(($# > 0)) || die "name the CMake presets to compare, for example: release plain clang"
programs=()
for preset in "$@"; do
    cmake --preset "$preset" >/dev/null
    cmake --build --preset "$preset" --target foamtex
    programs+=("$root/build/$preset/texgen/foamtex")
done
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# bake_all FOLDER COMMAND...: bakes a coarsening foam, a patch, a loop, a boil, and all maps of a torus and of a patch.
bake_all() {
    local folder=$1 maps
    shift
    maps=$("${programs[0]}" maps | cut -d ' ' -f 1 | paste -s -d ,)
    mkdir -p "$folder"
    (
        cd "$folder"
        "$@" bake coarsening -q --size 128 --set foam.bubbles=400 --frames 1-24 --maps albedo,pressure \
            --out 'coarsening/{map}.####.png'
        "$@" bake soap_raft -q --size 96 --set foam.bubbles=60 --frames 1-24 --maps height,growth,lit \
            --out 'patch/{map}.####.png'
        "$@" bake sea_foam -q --size 96 --set foam.bubbles=60 --set frames.count=24 --maps height,motion \
            --out 'loop/{map}.####.png'
        "$@" bake fizz -q --size 96 --set foam.bubbles=30 --set frames.count=24 --frames 1-24 --maps height,lit \
            --out 'boil/{map}.####.png'
        "$@" bake sea_foam -q --size 96 --set foam.bubbles=60 --set frames.count=24 --frames 3 --maps "$maps" \
            --out 'torus_maps/####.exr'
        "$@" bake soap_raft -q --size 96 --set foam.bubbles=60 --frames 3 --maps "${maps/maze,maze_solution,/}" \
            --out 'patch_maps/####.exr'
    )
}

# check NAME COMMAND...: bakes with a command and compares the pictures with those of the first program.
check() {
    local name=$1 part
    shift
    bake_all "$work/$name" "$@"
    for part in "$work/reference"/*; do
        "${programs[0]}" compare --fail 0 -q "$part" "$work/$name/${part##*/}" ||
            failures+=("$name: ${part##*/}")
    done
    rm -rf -- "${work:?}/$name"
    say "compared: $name"
}

failures=()
bake_all "$work/reference" "${programs[0]}"
say "baked the reference with ${programs[0]}"
for ((k = 1; k < $#; ++k)); do
    # shellcheck disable=SC2086  # FOAM_RUNNER is a command with arguments
    check "${*:k + 1:1}" ${FOAM_RUNNER:-} "${programs[k]}"
done
for level in baseline avx2; do
    if [[ $level == baseline ]] || grep -qw "$level" /proc/cpuinfo; then
        check "$level" env FOAMTEX_SIMD="$level" "${programs[0]}"
    fi
done
check old_libc env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX512F,-AVX512VL,-AVX2,-AVX2_Usable,-FMA,-FMA_Usable,-FMA4,-AVX \
    "${programs[0]}"

((${#failures[@]} == 0)) || die "pixels differ: ${failures[*]}"
say "all pixels are the same"
