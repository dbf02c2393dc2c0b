#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads KTX2 files of foamtex with ktx-parse and fzstd: single textures of every pixel format, and arrays. See ktx2.mjs.
# Usage: tests/interop/ktx2.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

# shellcheck source=tests/interop/textures.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/textures.sh"
skip_without node /usr/bin/convert tests/interop
bake_textures 64x32
node tests/interop/ktx2.mjs "$scratch" 64x32
say "all files were read"
