#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Writes the add-on as a zip that Blender installs.
#
#     samples/blender/zip.sh [FILE]        default: out/foamtex_import.zip
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
file=$(realpath -m -- "${1:-$root/out/foamtex_import.zip}")
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT

mkdir -p -- "$(dirname -- "$file")"
cp -R -- "$root/samples/blender/foamtex_import" "$scratch/"
find "$scratch" -name __pycache__ -prune -exec rm -rf -- {} +
cd -- "$scratch"
rm -f -- "$file"
python3 -m zipfile -c "$file" foamtex_import
