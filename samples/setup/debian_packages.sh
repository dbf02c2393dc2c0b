#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds the Debian packages foamtex, foamtex-dev and python3-foamtex, and the source package, in build/package.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

ensure_packages "${foam_build_packages[@]}" "${foam_python_packages[@]}" dpkg-dev file gzip git
rm -f build/package/*.deb build/package/*.tar.gz
cmake --preset package
cmake --build --preset package
(cd build/package && cpack -G DEB)
# The source package contains the files of the last commit, and its hash (texgen/cli/commit.txt).
version=$(dpkg-deb -f build/package/foamtex_*.deb Version)
git archive --format=tar.gz --prefix="foamtex-$version/" -o "build/package/foamtex-$version.tar.gz" HEAD
ls -l build/package/*.deb build/package/*.tar.gz
