#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Bakes the same presets with several builds of foamtex, at each SIMD level, and with versions of the C library's
# functions for older processors, and checks that all pixels are the same.
#
#     tests/same_pixels.sh PROGRAM...      for example build/release/texgen/foamtex build/clang/texgen/foamtex
#     tests/same_pixels.sh                 builds three programs first: GCC -O3, GCC -O0 and Clang -O1
#     FOAM_RUNNER="qemu-aarch64 -L ..." tests/same_pixels.sh PROGRAM FOREIGN_PROGRAM
#
# FOAM_RUNNER runs all programs but the first one. The first program also compares the pictures.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

# build NAME COMPILER FLAGS: builds the program alone in build/NAME, and adds it to the programs.
build() {
    cmake -S . -B "build/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DFOAM_TESTS=OFF \
        -DFOAM_BENCHMARKS=OFF -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS_RELEASE="$3" >/dev/null
    cmake --build "build/$1" --target foamtex
    programs+=("build/$1/texgen/foamtex")
}

programs=("$@")
if ((${#programs[@]} == 0)); then
    build same_gcc g++ "-O3 -DNDEBUG"
    build same_plain g++ -O0
    build same_clang clang++ "-O1 -DNDEBUG"
fi
mapfile -t programs < <(realpath -- "${programs[@]}")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT

# bake_all FOLDER COMMAND...: bakes a coarsening foam, a patch, a loop, and all maps of a torus and of a patch.
bake_all() {
    local folder=$1 maps
    shift
    maps=$("${programs[0]}" maps | cut -d ' ' -f 1 | paste -s -d ,)
    mkdir -p "$folder"
    (
        cd "$folder"
        "$@" bake coarsening -q --size 128 --set foam.bubbles=1500 --frames 1-24 --maps albedo,pressure \
            --out 'coarsening/{map}.####.png'
        "$@" bake soap_raft -q --size 96 --set foam.bubbles=60 --frames 1-24 --maps height,growth,lit \
            --out 'patch/{map}.####.png'
        "$@" bake sea_foam -q --size 96 --set foam.bubbles=60 --set frames.count=24 --maps height,motion \
            --out 'loop/{map}.####.png'
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
for program in "${programs[@]:1}"; do
    # shellcheck disable=SC2086  # FOAM_RUNNER is a command with arguments
    check "$(basename "$(dirname "$(dirname "$program")")")" ${FOAM_RUNNER:-} "$program"
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
