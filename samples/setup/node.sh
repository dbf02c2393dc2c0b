# SPDX-License-Identifier: Apache-2.0

# shellcheck shell=bash
# Functions that install Node.js and packages of npm for tests. The script that sources this file has sourced packages.sh
# before, and its working directory is the root of the checkout.

# ensure_node: installs Node.js and npm if the commands are missing. They need not be Debian's packages.
ensure_node() {
    local -a missing=()
    command -v node >/dev/null || missing+=(nodejs)
    command -v npm >/dev/null || missing+=(npm)
    ((${#missing[@]} == 0)) || ensure_packages "${missing[@]}"
}

# npm_folder FOLDER: prints the folder for the packages that FOLDER/package-lock.json lists.
npm_folder() {
    printf 'build/npm/%s\n' "$(basename "$1")"
}

# has_npm FOLDER: succeeds if the packages that FOLDER/package-lock.json lists are installed.
has_npm() {
    cmp -s "$1/package-lock.json" "$(npm_folder "$1")/installed.json"
}

# ensure_npm FOLDER...: installs the packages of npm that FOLDER/package-lock.json lists, in exactly these versions, into
# build/npm/NAME, where NAME is the name of the folder. No scripts of the packages are run.
ensure_npm() {
    local from to
    ensure_node
    for from in "$@"; do
        has_npm "$from" && continue
        say "installing the packages of npm for $from"
        to=$(npm_folder "$from")
        mkdir -p "$to"
        cp "$from/package.json" "$from/package-lock.json" "$to"
        (cd "$to" && npm ci --ignore-scripts --no-audit --no-fund) || die "npm could not install the packages for $from"
        cp "$from/package-lock.json" "$to/installed.json"
    done
}

# is_available NEEDED: succeeds if NEEDED is installed: a command, a Debian package, or the npm packages of a folder such as
# tests/browser.
is_available() {
    if [[ -d $1 ]]; then
        has_npm "$1"
    else
        command -v "$1" >/dev/null || is_installed "$1"
    fi
}

# skip_without NEEDED...: ends a test with the exit code of a skipped test if something is not available. In CI, where
# everything must be installed, the test fails.
skip_without() {
    local needed
    for needed in "$@"; do
        is_available "$needed" && continue
        [[ -z ${CI:-} ]] || die "not installed: $needed"
        say "skipped: $needed is not installed; tests/run.sh installs it"
        exit 77
    done
}
