#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Builds foamtex for 64-bit ARM, runs it in the emulator of QEMU, and compares its pixels with those of the program
# for this machine (same_pixels.sh). Needs Debian. The packages for ARM are unpacked in build/aarch64_root and are not
# installed.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

readonly system=$root/build/aarch64_root packages=$root/build/aarch64_packages

# foreign_apt ARGUMENT...: runs apt-get for ARM, as on a machine on which no package is installed.
foreign_apt() {
    apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::State::lists="$packages/lists" \
        -o Dir::State::status="$packages/status" -o Dir::Cache::archives="$packages/archives" \
        -o Dir::Cache::pkgcache= -o Dir::Cache::srcpkgcache= "$@"
}

# Unpacks the libraries of foamtex and of C++, with all packages that they depend on.
unpack_libraries() {
    local -a libraries=(libstdc++-12-dev)
    local name package
    for name in "${foam_build_packages[@]}"; do
        case $name in
            *-dev) libraries+=("$name") ;;
        esac
    done
    rm -rf "$system.part"
    mkdir -p "$packages"/{lists,archives}/partial
    : >"$packages/status"
    foreign_apt update
    foreign_apt install -y --no-install-recommends --download-only "${libraries[@]}"
    for package in "$packages"/archives/*.deb; do dpkg -x "$package" "$system.part"; done
    mv "$system.part" "$system"
}

ensure_packages "${foam_build_packages[@]}" g++-aarch64-linux-gnu qemu-user
[[ -d $system ]] || unpack_libraries
FOAM_RUNNER="qemu-aarch64 -L $system" tests/same_pixels.sh release aarch64
