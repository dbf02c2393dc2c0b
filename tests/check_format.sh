#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Fails if the format of a source differs from the output of clang-format.
#
#     tests/check_format.sh          reports the differences
#     tests/check_format.sh --fix    rewrites the files
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

case ${1:-} in
    '') mode=(--dry-run --Werror) ;;
    --fix) mode=(-i) ;;
    *) die "unknown option $1; there is --fix" ;;
esac

ensure_packages clang-format
mapfile -d '' -t sources < <(find core texgen tests -name '*.h' -print0 -o -name '*.cpp' -print0)
((${#sources[@]} > 0)) || die "no source found in core, texgen and tests"
clang-format "${mode[@]}" "${sources[@]}"
say "${#sources[@]} files are formatted as .clang-format says"
