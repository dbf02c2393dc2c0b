#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Tests the page of the studio in Chromium, with the real program.
#
#     tests/studio/studio.sh                       # all tests, with the program of the preset ci
#     tests/studio/studio.sh PROGRAM FILE...       # the tests in these files, such as tests/studio/bake.test.mjs
#     FOAM_SCREENSHOTS=FOLDER tests/studio/studio.sh        # also writes screenshots into the folder
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
FOAMTEX=$(realpath -- "${1:-$root/build/ci/texgen/foamtex}")
export FOAMTEX
shift $(($# > 0 ? 1 : 0))
files=("$@")
((${#files[@]} > 0)) || files=("$root"/tests/studio/*.test.mjs)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh

skip_without node "${FOAM_CHROMIUM:-/usr/bin/chromium}" tests/browser tests/studio
node --test --test-concurrency=1 "${files[@]}"
