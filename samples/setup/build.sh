# SPDX-License-Identifier: Apache-2.0

# shellcheck shell=bash
# The path of the program that the samples run, and a function that builds it. Other scripts source this file, with the
# root of the checkout as working directory.

# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

# shellcheck disable=SC2034  # used where this file is sourced
foamtex=build/quickstart/texgen/foamtex

# The approximate processor time of a build from scratch, in minutes, for the message below.
build_minutes=8

build_foamtex() {
    ensure_packages "${foam_build_packages[@]}"
    local cores start=$SECONDS
    cores=$(nproc)
    say "building foamtex in build/quickstart; from nothing that takes about" \
        "$(((build_minutes + cores - 1) / cores)) min on $cores cores, after a change seconds"
    cmake --preset quickstart >/dev/null
    cmake --build --preset quickstart --target foamtex
    say "built foamtex in $((SECONDS - start)) s"
}
