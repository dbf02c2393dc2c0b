#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads DDS files of foamtex with Pillow, and compares their pixels with PNGs of the same frame. See dds.sh."""

import math
import pathlib
import subprocess
import sys

import numpy
from PIL import Image

# The smallest PSNR in decibels that block compression may give, by map. 40 dB is an error of about 2.5 of 255.
SMALLEST = {"albedo": 42.0, "lit": 40.0, "ORM": 40.0, "normal": 36.0}


def psnr(a, b):
    error = numpy.mean((a.astype(float) - b.astype(float)) ** 2)
    return math.inf if error == 0 else 10 * math.log10(255**2 / error)


def bake(program, folder, suffix, extra=()):
    subprocess.run([program, "bake", "lava", "--frames", "1", "--size", "256", "--maps", "albedo,lit,normal", "--pack",
                    "ORM=occlusion,roughness,metallic", "--out", f"{folder}/{{map}}{suffix}", "-q", *extra], check=True)


def main():
    program, scratch = sys.argv[1:]
    bake(program, f"{scratch}/png", ".png")
    bake(program, f"{scratch}/compressed", ".dds")
    bake(program, f"{scratch}/plain", ".dds", ["--set", "output.block_compression=none"])
    for name, smallest in SMALLEST.items():
        png = numpy.array(Image.open(f"{scratch}/png/{name}.png").convert("RGB"))
        channels = 2 if name == "normal" else 3  # a texture stores x and y of a normal
        for folder, least in (("compressed", smallest), ("plain", math.inf)):
            dds = numpy.array(Image.open(pathlib.Path(scratch, folder, f"{name}.dds")))[..., :channels]
            found = psnr(png[..., :channels], dds)
            print(f"{folder} {name}: {found:.1f} dB")
            if found < least:
                sys.exit(f"{folder} {name}: the PSNR is below {least} dB")


if __name__ == "__main__":
    main()
