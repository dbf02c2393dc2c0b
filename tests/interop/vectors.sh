#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads SVG, PDF and DXF files of foamtex with third-party programs (vectors.py).
# Usage: tests/interop/vectors.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
# shellcheck source=samples/setup/packages.sh
source "$root/samples/setup/packages.sh"
# shellcheck source=samples/setup/node.sh
source "$root/samples/setup/node.sh"
skip_without librsvg2-bin poppler-utils python3-ezdxf libxml2-utils python3-pil python3-numpy
program=$(realpath -- "${1:-$root/build/ci/texgen/foamtex}")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

/usr/bin/python3 "$root/tests/interop/vectors.py" "$program" "$scratch"
say "all files were read"
