#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds foamtex and bakes the preset sea_foam into out/. A fresh Debian 12 is all it needs.
#
#     samples/quickstart.sh [OPTION OF foamtex bake]...
#     samples/quickstart.sh --frames 1-4 --size 256
#
# Relative paths among the options start at the top of the checkout.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

bake() {
    mkdir -p out
    # A second early: a file's time is coarse, and a quick bake's files could bear the same.
    touch -d '1 second ago' build/quickstart/bake_started
    say "baking the preset sea_foam"
    "$foamtex" bake sea_foam "$@"
}

# One line for each file, or for each numbered sequence: its first and last file, and how many.
summarize() {
    sort | awk '
        { name = $0; sub(/[.][0-9]+[.][^.\/]*$/, ".#", name) }
        !(name in count) { order[++names] = name; first[name] = $0 }
        { count[name]++; last[name] = $0 }
        END {
            for (i = 1; i <= names; i++) {
                name = order[i]
                line = "    " first[name]
                if (count[name] > 1)
                    line = line " ... " last[name] " (" count[name] " files)"
                print line
            }
        }'
}

report() {
    local files
    files=$(find out -type f -newer build/quickstart/bake_started | summarize)
    if [[ -z $files ]]; then
        say "done; nothing new in $root/out"
        return
    fi
    say "done; written in $root:"
    printf '%s\n' "$files"
}

build_foamtex
bake "$@"
report
