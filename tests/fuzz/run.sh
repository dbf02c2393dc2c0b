#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Fuzzes readers of the program with libFuzzer, under the address and undefined-behavior sanitizers. Prints a table of
# the runs, the crashes and the coverage. New inputs stay in build/fuzz/work/corpus, so that the next run continues from
# them; inputs that crash stay in build/fuzz/work/findings.
#
#     tests/fuzz/run.sh 10                   all targets, 10 minutes each
#     tests/fuzz/run.sh 10 png exr           these targets
#     tests/fuzz/run.sh --minimize           replaces the checked-in corpora by smaller ones of the same coverage
#
# Limits of a run: 1 second of processor time, 512 MiB of memory. Environment: JOBS, the number of targets that are fuzzed
# at once (default: the number of processors).
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

readonly work=build/fuzz/work program=build/fuzz/tests/fuzz/fuzz_readers seeds=tests/fuzz/corpus
readonly largest_input=65536  # bytes
# The quarantine of the address sanitizer counts as memory of the run.
export ASAN_OPTIONS=quarantine_size_mb=16:allocator_may_return_null=0 UBSAN_OPTIONS=print_stacktrace=1

# dictionary_of TARGET: prints the option of libFuzzer with the dictionary of a target, or nothing if it has none.
dictionary_of() {
    case $1 in
        cache_file | cache_state) echo -dict=tests/fuzz/dictionaries/cache.dict ;;
        cache_info | earlier_sheets | flipbook | foam_state | loop_start | manifest)
            echo -dict=tests/fuzz/dictionaries/json.dict
            ;;
        job_file | preset | profile | set_argument | tolerances) echo -dict=tests/fuzz/dictionaries/toml.dict ;;
        file_pattern | frame_range | wkt_polygon) echo -dict=tests/fuzz/dictionaries/text.dict ;;
        dds | evolver | exr | ktx2 | png | studio | svg_outline) echo "-dict=tests/fuzz/dictionaries/$1.dict" ;;
    esac
}

# fuzz SECONDS TARGET: fuzzes a target. Starts again after a crash, until the time is over.
fuzz() {
    local end=$((SECONDS + $1)) target=$2 left
    local -a dictionary
    mapfile -t dictionary < <(dictionary_of "$2")
    mkdir -p "$work/corpus/$target" "$work/findings/$target"
    : >"$work/$target.log"
    while left=$((end - SECONDS)) && ((left > 0)); do
        # libFuzzer measures wall time, which depends on other work; the target itself limits processor time.
        FOAMTEX_FUZZ_TARGET=$target "$program" -max_total_time="$left" -timeout=300 -report_slow_units=300 -rss_limit_mb=512 \
            -max_len=$largest_input "${dictionary[@]}" -print_final_stats=1 -verbosity=1 \
            -artifact_prefix="$work/findings/$target/" "$work/corpus/$target" "$seeds/$target" \
            >>"$work/$target.log" 2>&1 && break
        sleep 1
    done
}

# print_row TARGET: prints the row of the table for a target.
print_row() {
    local log=$work/$1.log
    printf '| %s | %s | %s | %s | %s |\n' "$1" \
        "$(awk '/number_of_executed_units/ {n += $2} END {print n + 0}' "$log")" \
        "$(find "$work/findings/$1" -type f | wc -l)" \
        "$(grep -oE ' cov: [0-9]+' "$log" | awk '$2 > n {n = $2} END {print n + 0}')" \
        "$(awk '/peak_rss_mb/ && $2 > n {n = $2} END {print n + 0}' "$log")"
}

# minimize TARGET: replaces the checked-in corpus of a target.
minimize() {
    local merged=$work/merged/$1
    rm -rf "$merged" && mkdir -p "$merged" "$work/corpus/$1"
    FOAMTEX_FUZZ_TARGET=$1 "$program" -merge=1 -max_len=$largest_input "$merged" "$seeds/$1" "$work/corpus/$1" \
        >"$work/$1.merge.log" 2>&1
    rm -rf "${seeds:?}/$1" && mv "$merged" "$seeds/$1"
}

build() {
    ensure_packages "${foam_build_packages[@]}" "${foam_test_packages[@]}" clang libclang-rt-14-dev
    cmake --preset fuzz >/dev/null
    cmake --build --preset fuzz --target fuzz_readers
}

# all_targets: prints the names of all targets. Each target has a folder of its name in the corpus.
all_targets() {
    find "$seeds" -mindepth 1 -maxdepth 1 -type d -printf '%f\n' | sort
}

(($# > 0)) || die "how many minutes? For example: tests/fuzz/run.sh 10"
minutes=$1
shift
targets=("$@")
((${#targets[@]} > 0)) || mapfile -t targets < <(all_targets)
build
mkdir -p "$work"
export -f fuzz dictionary_of minimize
export work program seeds largest_input
if [[ $minutes == --minimize ]]; then
    for target in "${targets[@]}"; do minimize "$target"; done
    exit
fi
[[ $minutes =~ ^[0-9]+$ ]] || die "'$minutes' is not a number of minutes"
printf '%s\0' "${targets[@]}" |
    xargs -0 -n 1 -P "${JOBS:-$(nproc)}" bash -c 'fuzz "$1" "$2"' fuzz $((60 * minutes))
printf '| target | runs | crashes | covered edges | memory, MiB |\n|---|---|---|---|---|\n'
for target in "${targets[@]}"; do print_row "$target"; done
crashes=$(find "$work/findings" -type f | wc -l)
((crashes == 0)) || die "$crashes inputs that crash are in $work/findings"
