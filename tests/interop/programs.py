#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Decodes DDS files of foamtex with nvdecompress and OpenImageIO, and compares them with PNGs. See programs.sh."""

import math
import pathlib
import subprocess
import sys

import numpy
from PIL import Image

SCRATCH = pathlib.Path(sys.argv[1])
BC7ENC = sys.argv[2]
# The channels of OpenImageIO, and the smallest PSNR in decibels that block compression may give, as in three.mjs.
MAPS = {"ORM": ("R,G,B", 37), "normal": ("R,G,0", 32), "roughness": ("Y", 40)}


def pixels_of(path):
    """Returns the channels of an image, one after the other."""
    pixels = numpy.array(Image.open(path)).astype(float)
    return pixels[..., None] if pixels.ndim == 2 else pixels


def psnr(a, b):
    channels = min(a.shape[2], b.shape[2])
    error = numpy.mean((a[..., :channels] - b[..., :channels]) ** 2)
    return math.inf if error == 0 else 10 * math.log10(255**2 / error)


def check(name, found, least):
    print(f"{name}: {found:.1f} dB")
    if found < least:
        sys.exit(f"{name}: the PSNR is below {least} dB")


def means(pixels):
    """Returns the means of 2 x 2 pixels."""
    return (pixels[::2, ::2] + pixels[1::2, ::2] + pixels[::2, 1::2] + pixels[1::2, 1::2]) / 4


def half_size(pixels, name):
    """Returns mip level 1. That of normals is the direction of the mean vector."""
    if name != "normal":
        return means(pixels)
    vectors = means(pixels / 127.5 - 1)
    return (vectors / numpy.linalg.norm(vectors, axis=2, keepdims=True) + 1) * 127.5


def stored(pixels, name):
    """Returns the channels that a texture stores, which of a normal are x and y."""
    return pixels[..., :2] if name == "normal" else pixels


def read_with_open_image_io(name, channels, least):
    png = pixels_of(SCRATCH / f"png/{name}.0033.png")
    for level, expected in enumerate([png, half_size(png, name)]):
        out = SCRATCH / "read.png"
        subprocess.run(["oiiotool", SCRATCH / f"dds/{name}.0033.dds", "--selectmip", str(level), "--ch", channels,
                        "-o", out], check=True)
        read = pixels_of(out)
        if read.shape[:2] != expected.shape[:2]:
            sys.exit(f"OpenImageIO reads a level of {read.shape}")
        check(f"OpenImageIO, {name}, level {level}", psnr(stored(read, name), stored(expected, name)), least)


def read_with_nvdecompress(name, code, least):
    """nvdecompress 2.0.8 knows BC4 and BC5 only by the codes of Direct3D 9, so the header is replaced."""
    dds = (SCRATCH / f"dds/{name}.0033.dds").read_bytes()
    (SCRATCH / "legacy.dds").write_bytes(dds[:84] + code + dds[88:128] + dds[148:])
    subprocess.run(["nvdecompress", "legacy.dds"], check=True, cwd=SCRATCH)
    read = pixels_of(SCRATCH / "legacy.tga")
    png = pixels_of(SCRATCH / f"png/{name}.0033.png")
    check(f"nvdecompress, {name}", psnr(stored(read, name), stored(png, name)), least)


def compare_with_bc7enc(name):
    """Block compression with BC7 must be within 1 dB of bc7enc with its option -C."""
    png = SCRATCH / f"png/{name}.0033.png"
    other = SCRATCH / "other.dds"
    subprocess.run([BC7ENC, "-q", "-g", "-C", png, other], check=True, stdout=subprocess.DEVNULL)
    least = psnr(pixels_of(png), pixels_of(other))
    ours = psnr(pixels_of(png), pixels_of(SCRATCH / f"dds/{name}.0033.dds"))
    check(f"BC7 of {name}, beside {least:.1f} dB of bc7enc", ours, least - 1)


def main():
    for name, (channels, least) in MAPS.items():
        read_with_open_image_io(name, channels, least)
    read_with_nvdecompress("roughness", b"ATI1", MAPS["roughness"][1])
    read_with_nvdecompress("normal", b"ATI2", MAPS["normal"][1])
    for name in ("albedo", "ORM"):
        compare_with_bc7enc(name)


if __name__ == "__main__":
    main()
