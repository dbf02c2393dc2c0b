#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0

# Usage: run.sh BUILD SAMPLES
# Installs the libraries of a build folder into a temporary folder, builds the programs of samples/library with the
# installed package, and runs them. Also checks that each installed header compiles by itself, that the shared libraries
# export nothing but the names of the headers, and that pkg-config and the static libraries work.
set -euo pipefail

build=$1
samples=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
prefix=$work/prefix
say() { printf '==> %s\n' "$*" >&2; }

cmake --install "$build" --prefix "$prefix" >"$work/install.txt"
libraries=$(dirname "$(find "$prefix" -name libfoam_core.so)")

say "each header compiles by itself"
while read -r header; do
    for compiler in g++ clang++; do
        "$compiler" -std=c++20 -fsyntax-only -Wall -Wextra -Wpedantic -Werror -I "$prefix/include" -x c++ - \
            <<<"#include <foamtex/$(basename "$header")>"
    done
done < <(find "$prefix/include/foamtex" -name '*.h')
if grep -rE '#include <(Eigen|png|Imf|OpenEXR|boost|fmt)' "$prefix/include"; then
    say "a header includes a library that users would have to install"
    exit 1
fi

say "the shared libraries export nothing else"
for library in core texgen; do
    if nm -DC --defined-only "$libraries/libfoam_$library.so" | cut -d' ' -f3- |
        grep -vE '^(typeinfo (name )?for |vtable for )?foamtex::'; then
        say "libfoam_$library.so exports the names above"
        exit 1
    fi
done

say "programs with the shared libraries"
cmake -S "$samples" -B "$work/samples" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release >"$work/cmake.txt"
cmake --build "$work/samples" >"$work/build.txt"
"$work/samples/bubbles" | tee "$work/bubbles.txt"
"$work/samples/stirring" | tee "$work/stirring.txt"
"$work/samples/picture" "$work" | tee "$work/picture.txt"
# Growth as measured agrees with von Neumann's law to the last digit that is printed.
awk 'NR > 1 && ($3 - $4 > 2e-5 || $4 - $3 > 2e-5) { bad = 1 } END { exit bad || NR < 6 }' "$work/bubbles.txt"
(($(wc -l <"$work/stirring.txt") == 13))
[[ $(head -c 15 "$work/lava_17.ppm" | head -1) == P6 ]]

say "pkg-config"
PKG_CONFIG_PATH=$libraries/pkgconfig
export PKG_CONFIG_PATH
read -ra flags < <(pkg-config --cflags --libs foam_texgen)
g++ -std=c++20 "$samples/picture.cpp" -o "$work/with_pkg_config" "${flags[@]}" -Wl,-rpath,"$libraries"
"$work/with_pkg_config" "$work" >"$work/again.txt"
cmp "$work/picture.txt" "$work/again.txt"

say "programs with the static libraries"
mkdir "$work/static"
cat >"$work/static/CMakeLists.txt" <<'CMAKE'
cmake_minimum_required(VERSION 3.25)
project(static_libraries LANGUAGES CXX)
find_package(foamtex REQUIRED COMPONENTS texgen_static)
add_executable(picture ${SAMPLES}/picture.cpp)
target_link_libraries(picture PRIVATE foam::texgen_static)
CMAKE
cmake -S "$work/static" -B "$work/static/build" -DCMAKE_PREFIX_PATH="$prefix" -DSAMPLES="$samples" >"$work/cmake.txt"
cmake --build "$work/static/build" >"$work/build.txt"
"$work/static/build/picture" "$work" >"$work/again.txt"
cmp "$work/picture.txt" "$work/again.txt"
say "all checks passed"
