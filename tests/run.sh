#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds foamtex with all its tests and benchmarks, and runs every test.
#
#     tests/run.sh [OPTION OF ctest]...
#     tests/run.sh -R T1                   only the tests whose name contains T1
#     FOAM_PRESET=asan tests/run.sh        another CMake preset than release
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh
# shellcheck source=samples/setup/node.sh
source samples/setup/node.sh

preset=${FOAM_PRESET:-release}

ensure_packages "${foam_build_packages[@]}" "${foam_test_packages[@]}"
ensure_npm tests/browser tests/interop tests/interop/scenes tests/studio
say "building in build/$preset"
cmake --preset "$preset"
cmake --build --preset "$preset"
say "running the tests"
ctest --preset "$preset" -j "$(nproc)" "$@"
