#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Draws KTX2 textures of foamtex with three.js in Chromium, and compares the pixels with PNGs. See three.mjs.
# Usage: tests/interop/three.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

# shellcheck source=tests/interop/textures.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/textures.sh"
skip_without node "${FOAM_CHROMIUM:-/usr/bin/chromium}" tests/browser tests/interop
bake_textures 128x64
node tests/interop/three.mjs "$scratch"
say "all textures were drawn"
