#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds foamtex and bakes the preset sea_foam into out/. Needs only a fresh Debian 12.
#
#     samples/quickstart.sh [OPTION OF foamtex bake]...
#     samples/quickstart.sh --frames 1-4 --size 256
#
# Relative paths in the options are relative to the root of the checkout.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/build.sh
source samples/setup/build.sh

bake() {
    mkdir -p out
    # The mark is one second old, because file times are coarse: otherwise files of a quick bake could be as old as it.
    touch -d '1 second ago' build/quickstart/bake_started
    say "baking the preset sea_foam"
    "$foamtex" bake sea_foam "$@"
}

# Prints one line per file. A numbered sequence has one line with its first and last file and the number of files.
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
