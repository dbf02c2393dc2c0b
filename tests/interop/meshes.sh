#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads STL files of foamtex with admesh and GLB files with the validator of Khronos, and compares volumes (meshes.py).
# Usage: tests/interop/meshes.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

program=$(realpath -- "${1:-$(dirname -- "${BASH_SOURCE[0]}")/../../build/ci/texgen/foamtex}")
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh
skip_without admesh python3-ezdxf python3-pil python3-numpy node tests/interop/scenes
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

/usr/bin/python3 tests/interop/meshes.py "$program" "$scratch"
node tests/interop/meshes.mjs "$scratch"
say "all meshes were read"
