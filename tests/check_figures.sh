#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Draws the diagrams that need no simulation, and fails if one of them differs from its file in samples/figures. For
# example, rooms.svg differs after a call of foam_room in a CMakeLists.txt file has changed.
#
#     tests/check_figures.sh
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

python3 -B samples/figures/diagrams --out "$scratch"
status=0
for drawn in "$scratch"/*.svg; do
    name=$(basename -- "$drawn" .svg)
    if ! cmp -s -- "$drawn" "samples/figures/$name.svg"; then
        echo "check_figures: samples/figures/$name.svg is out of date; run samples/figures/make.sh $name" >&2
        status=1
    fi
done
exit "$status"
