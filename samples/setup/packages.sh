# SPDX-License-Identifier: Apache-2.0

# shellcheck shell=bash
# shellcheck disable=SC2034  # the lists are used where this file is sourced
# The Debian 12 packages that foamtex needs, and a function that installs them. Other scripts source this file.

foam_build_packages=(
    g++ cmake ninja-build pkg-config
    libeigen3-dev libboost-dev libpng-dev zlib1g-dev libisal-dev libdeflate-dev libopenexr-dev libxxhash-dev
    libzstd-dev libcairo2-dev libglu1-mesa-dev
    libcli11-dev libtomlplusplus-dev libfmt-dev libpugixml-dev
    nlohmann-json3-dev
)
foam_test_packages=(
    libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libmpfr-dev evolver gnuplot-nox
    pngcheck apngdis ffmpeg imagemagick openexr openimageio-tools python3 python3-jsonschema
    libnvtt-bin python3-numpy python3-pil chromium libxml2-utils
    librsvg2-bin poppler-utils python3-ezdxf admesh
    clang python3-dev pybind11-dev python3-pytest python3-build python3-wheel python3-matplotlib mypy doxygen
)
foam_python_packages=(python3-dev pybind11-dev python3-numpy)
foam_check_packages=(clang libclang-rt-14-dev clang-format clang-tidy ccache python3 reuse)

say() {
    printf '==> %s\n' "$*" >&2
}

die() {
    printf '%s: error: %s\n' "$(basename "$0")" "$*" >&2
    exit 1
}

is_installed() {
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null) == installed ]]
}

print_missing() {
    local package
    for package in "$@"; do
        is_installed "$package" || printf '%s\n' "$package"
    done
}

apt_get() {
    local -a command=(env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120)
    ((EUID == 0)) || command=(sudo "${command[@]}")
    "${command[@]}" "$@"
}

# ensure_packages PACKAGE...: installs the packages that are missing, and prints their names.
ensure_packages() {
    if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
        die "this is not a Debian system; the packages needed are, by their Debian names: $*"
    fi

    local -a missing
    mapfile -t missing < <(print_missing "$@")
    if ((${#missing[@]} == 0)); then
        say "no package is missing"
        return
    fi

    if ((EUID != 0)) && ! command -v sudo >/dev/null; then
        die "installing packages takes root or sudo; missing are: ${missing[*]}"
    fi
    say "installing: ${missing[*]}"
    apt_get update || say "apt-get update failed; trying with the package lists at hand"
    apt_get install -y --no-install-recommends "${missing[@]}" ||
        die "these packages could not be installed: ${missing[*]}"
}
