#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Measures how many lines and branches of core and texgen the tests execute, with clang's source-based coverage. Builds in
# build/coverage.
#
#     tests/coverage.sh                      all tests: a table of the folders
#     tests/coverage.sh --missing            also the lines that no test executes
#     tests/coverage.sh --fuzz               the corpora of tests/fuzz: the lines of each reader that its corpus executes
#     tests/coverage.sh --fuzz --missing
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

readonly build=build/coverage
readonly work=$build/profiles

# profile_into NAME COMMAND...: runs a command. The counts of all its processes are merged into files work/NAME-*.
profile_into() {
    local name=$1
    shift
    LLVM_PROFILE_FILE=$PWD/$work/$name-%4m.profraw "$@" >"$work/$name.log" 2>&1 ||
        say "$name failed; see $work/$name.log"
}

# export_counts NAME PROGRAM...: writes the counts of the lines of the programs to work/NAME.lcov.
export_counts() {
    local name=$1 program
    local -a objects=("$2")
    shift 2
    for program in "$@"; do objects+=(-object "$program"); done
    llvm-profdata-14 merge -sparse "$work/$name"-*.profraw -o "$work/$name.profdata"
    llvm-cov-14 export -format=lcov -instr-profile="$work/$name.profdata" "${objects[@]}" >"$work/$name.lcov"
}

measure_tests() {
    local -a programs=("$build"/tests/{core/core_tests,texgen/texgen_tests,stress/foam_stress} "$build/texgen/foamtex"
        "$build/tests/fuzz/fuzz_replay")
    cmake --build --preset coverage --target core_tests texgen_tests foam_stress fuzz_replay foamtex
    profile_into tests-core "${programs[0]}" &
    profile_into tests-texgen "${programs[1]}"
    wait
    profile_into tests-stress "${programs[2]}" --foams 5 --patches 5 --states 10 --max-bubbles 100
    for corpus in tests/fuzz/corpus/*; do
        profile_into "tests-fuzz-$(basename "$corpus")" "$build/tests/fuzz/fuzz_replay" "$(basename "$corpus")" "$corpus"
    done
    export_counts tests "${programs[@]}"
    tests/coverage_table.py "$work/tests.lcov" "$@"
}

measure_fuzz() {
    local corpus target
    cmake --build --preset coverage --target fuzz_replay
    for corpus in tests/fuzz/corpus/*; do
        target=$(basename "$corpus")
        profile_into "fuzz-$target" "$build/tests/fuzz/fuzz_replay" "$target" "$corpus"
        export_counts "fuzz-$target" "$build/tests/fuzz/fuzz_replay"
        tests/coverage_table.py "$work/fuzz-$target.lcov" --reader "$target" "$@"
    done
}

ensure_packages "${foam_build_packages[@]}" "${foam_test_packages[@]}" clang libclang-rt-14-dev llvm-14
cmake --preset coverage >/dev/null
rm -rf "$work" && mkdir -p "$work"
if [[ ${1:-} == --fuzz ]]; then
    shift
    measure_fuzz "$@"
else
    measure_tests "$@"
fi
