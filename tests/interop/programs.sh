#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
#
# Reads DDS files of foamtex with nvdecompress and OpenImageIO, see programs.py, and reads files of bc7enc with foamtex.
# Usage: tests/interop/programs.sh [PROGRAM], where PROGRAM is the program foamtex of the preset ci by default.
set -euo pipefail

# shellcheck source=tests/interop/textures.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/textures.sh"
skip_without libnvtt-bin openimageio-tools python3-pil python3-numpy tests/interop
bc7enc=$PWD/$(npm_folder tests/interop)/node_modules/@gpu-tex-enc/bc/bin/linux/bc7enc
if [[ $(uname -m) != x86_64 ]]; then
    say "skipped: the package of bc7enc has no program for $(uname -m)"
    exit 77
fi

bake png .png 128x64 --frames 33
bake dds .dds 128x64 --frames 33
/usr/bin/python3 tests/interop/programs.py "$scratch" "$bc7enc"

# BC4 and BC5 of bc7enc. The rms is that of its compression: 0.007 and 0.019.
for read in "-4 roughness" "-5 normal"; do
    read -r option map <<<"$read"
    "$bc7enc" -q -g -f "$option" "$scratch/png/$map.0033.png" "$scratch/other.dds" >/dev/null
    "$program" compare "$scratch/png/$map.0033.png" "$scratch/other.dds" --fail-rms 0.025 --warn-rms 0.025 ||
        die "foamtex does not read the $map of bc7enc"
done
say "all files were read"
