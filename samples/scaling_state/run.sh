#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Simulates a foam of 10,000 bubbles until ten are left, and writes tables and charts to
# out/scaling_state/. This takes minutes.
#
#     samples/scaling_state/run.sh [OPTION OF foamtex stats]...
#     samples/scaling_state/run.sh --set foam.bubbles=1000 --frames 1-270     a tenth of the bubbles; takes seconds
#     FOAM_FIGURES=1 samples/scaling_state/run.sh          also updates the figures of the README
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

sample=samples/scaling_state
out=out/scaling_state

# mean_time LOW HIGH: prints the mean time, in milliseconds, of the frames after the first with LOW to HIGH bubbles.
mean_time() {
    awk -F, -v low="$1" -v high="$2" '
        $1 > 1 && low <= $3 && $3 <= high { sum += $NF; count++ }
        END { if (count) printf "%.2f ms (%d frames)\n", 1000 * sum / count, count; else print "none" }
    ' "$out/stats.csv"
}

report() {
    say "time of a frame, mean:"
    printf '    of 9,900 to 10,000 bubbles  %s; the paper: 39.5 s\n' "$(mean_time 9900 10000)"
    printf '    of 11 bubbles               %s; the paper: 84 ms\n' "$(mean_time 11 11)"
}

build_foamtex
say "simulating"
"$foamtex" stats "$sample/scaling_state.toml" --out "$out" "$@"
report
[[ -z ${FOAM_FIGURES:-} ]] || cp "$out"/*.svg "$sample/"
