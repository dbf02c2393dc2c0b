# SPDX-License-Identifier: Apache-2.0

# shellcheck shell=bash
# The program that samples run, and how they build it. To be sourced at the top of the checkout.

# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

# shellcheck disable=SC2034  # used where this file is sourced
foamtex=build/quickstart/texgen/foamtex

build_foamtex() {
    ensure_packages "${foam_build_packages[@]}"
    say "building foamtex in build/quickstart (the first time takes minutes)"
    cmake --preset quickstart >/dev/null
    cmake --build --preset quickstart --target foamtex
}
