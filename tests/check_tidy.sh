#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Fails on any clang-tidy finding in the sources that CMake builds, tests included.
#
#     tests/check_tidy.sh                    all of them
#     tests/check_tidy.sh core/network       those whose path contains one of the words given
#
# A source in which nothing was found is not looked at again until it changes, or what it includes, its comments, its
# options, .clang-tidy or clang-tidy itself: their hash is kept in the user's cache folder for a month.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

export build_dir=build/tidy
export cache_dir=${XDG_CACHE_HOME:-$HOME/.cache}/foamtex/tidy

# compiled_sources [WORD]...
compiled_sources() {
    sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build_dir/compile_commands.json" |
        sort -u | filter_by_words "$@"
}

filter_by_words() {
    local -a patterns=()
    local word
    for word in "$@"; do
        patterns+=(-e "$word")
    done
    if (($# == 0)); then cat; else grep -F "${patterns[@]}" || true; fi
}

# hash_of SOURCE: of all that decides what is found in it, the same in any folder.
hash_of() (
    set -o pipefail
    compile=$(grep -m 1 -F -B 1 "\"file\": \"$1\"" "$build_dir/compile_commands.json" |
        sed -nE 's/^ *"command": "(.*) -o .*",$/\1/p' | sed 's/\\"/"/g')
    {
        # All that the compiler sees, and comments.
        eval "${compile#ccache } -E -C \"$1\"" && printf '%s\n' "$compile" &&
            find . -name .clang-tidy -not -path './build/*' | sort | xargs cat && clang-tidy --version
    } | sed "s|$PWD/*||g" | sha256sum | cut -d ' ' -f 1
)

# Prints nothing but findings; on its own line the file in work, so that a long run shows progress.
tidy_one() {
    local hash output
    hash=$(hash_of "$1") || hash=none
    [[ -e $cache_dir/$hash ]] && return
    printf '%s\n' "${1#"$PWD/"}"
    output=$(clang-tidy --quiet --warnings-as-errors='*' -p "$build_dir" "$1" 2>&1) || {
        printf '%s\n' "$output"
        return 1
    }
    [[ $hash == none ]] || touch "$cache_dir/$hash"
}
export -f hash_of tidy_one

ensure_packages "${foam_build_packages[@]}" "${foam_test_packages[@]}" clang-tidy
cmake --preset tidy >/dev/null
mapfile -t sources < <(compiled_sources "$@")
((${#sources[@]} > 0)) || die "no source to check"

mkdir -p "$cache_dir"
find "$cache_dir" -type f -mtime +30 -delete
say "clang-tidy over ${#sources[@]} files"
# shellcheck disable=SC2016  # the inner bash expands it
printf '%s\0' "${sources[@]}" |
    xargs -0 -n 1 -P "$(nproc)" bash -c 'tidy_one "$1"' tidy_one ||
    die "clang-tidy has findings, above"
say "clang-tidy finds nothing"
