#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Runs clang-tidy on the sources that CMake builds, including tests. Fails if there is any finding.
#
#     tests/check_tidy.sh                    all sources
#     tests/check_tidy.sh core/network       the sources whose path, from the folder of the project, matches a pattern
#     tests/check_tidy.sh ^core/ ^texgen/    the sources that match one of several patterns of grep
#
# Sources that CMake compiles together are checked together, which takes a quarter of the time. They are skipped if they
# had no findings and none of these has changed: the sources or their comments, a file that they include, their compiler
# options, .clang-tidy, or clang-tidy itself. A hash of all of these is kept in the user's cache folder for a month.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." >/dev/null && pwd)
cd -- "$root"
# shellcheck source=samples/setup/packages.sh
source samples/setup/packages.sh

export build_dir=build/tidy
export cache_dir=${XDG_CACHE_HOME:-$HOME/.cache}/foamtex/tidy

# compiled_sources [PATTERN]...: prints the files of the compiler that are, or include, a source whose path matches
# one of the patterns; without a pattern, all files.
compiled_sources() {
    local file patterns
    patterns=$(printf '%s\n' "${@:-.}")  # one per line, as grep takes them
    sed -nE 's/^ *"file": "(.*)",?$/\1/p' "$build_dir/compile_commands.json" | sort -u |
        while read -r file; do
            if sources_in "$file" | sed "s|^$root/||" | grep -e "$patterns" >/dev/null; then printf '%s\n' "$file"; fi
        done
}

# sources_in FILE: prints the sources that a file of CMake's unity build includes, or else the file itself.
sources_in() {
    if [[ $1 == */Unity/unity_* ]]; then sed -nE 's/^#include "(.*)"$/\1/p' "$1"; else printf '%s\n' "$1"; fi
}

# hash_of SOURCE: prints a hash of everything that determines its findings. It does not depend on the path of the
# checkout.
hash_of() (
    set -o pipefail
    compile=$(grep -m 1 -F -B 1 "\"file\": \"$1\"" "$build_dir/compile_commands.json" |
        sed -nE 's/^ *"command": "(.*) -o .*",$/\1/p' | sed 's/\\"/"/g')
    {
        # The preprocessed source, with comments, because they may contain NOLINT.
        eval "${compile#ccache } -E -C \"$1\"" && printf '%s\n' "$compile" &&
            find . -name .clang-tidy -not -path './build/*' | sort | xargs cat && clang-tidy --version
    } | sed "s|$PWD/*||g" | sha256sum | cut -d ' ' -f 1
)

# tidy_one SOURCE: prints the path of the source, so that a long run shows progress, and then its findings.
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
