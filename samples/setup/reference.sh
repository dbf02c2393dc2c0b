#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Writes the reference of the C++ libraries as HTML. Fails if Doxygen has a warning.
#
#     samples/setup/reference.sh [FOLDER]     FOLDER: build/reference by default
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
folder=$(realpath -m -- "${1:-$root/build/reference}")
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

ensure_packages doxygen
mkdir -p "$folder"
doxygen - < <(
    cat texgen/api/Doxyfile
    printf 'OUTPUT_DIRECTORY = "%s"\n' "$folder"
)
# Pages refer to figures by their place in the checkout; HTML_EXTRA_FILES has copied them beside the pages.
sed -i -E 's#src="(\.\./)+samples/figures/#src="#' "$folder"/html/*.html
say "the reference is in $folder/html/index.html"
