#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how near a frame between two frames of a bake comes to the frame that foamtex draws for that time.

    samples/godot/motion_blending.py FOLDER PRESET

FOLDER/coarse contains the maps albedo and motion of a loop of N frames, FOLDER/fine the map albedo of the same loop with
2 N frames. The arithmetic is that of foamtex_frames.gdshader. Prints the mean difference of codes, of 255, for a
cross-fade and for blending along the motion. Exits with 1 if the two loops do not show the same foam. Needs NumPy and
ImageMagick.
"""
import json
import pathlib
import subprocess
import sys

import numpy


def read_samples(path):
    """Returns the samples of an RGB image, from 0 to 1, as an array of rows from top to bottom."""
    size = subprocess.run(["identify", "-format", "%w %h", path], check=True, capture_output=True, text=True).stdout
    width, height = map(int, size.split())
    data = subprocess.run(["convert", path, "-depth", "16", "-endian", "LSB", "rgb:-"], check=True, capture_output=True)
    return numpy.frombuffer(data.stdout, dtype="<u2").reshape(height, width, 3) / 65535


def linear(codes):
    return numpy.where(codes <= 0.04045, codes / 12.92, ((codes + 0.055) / 1.055) ** 2.4)


def encoded(light):
    light = numpy.clip(light, 0, 1)
    return numpy.where(light <= 0.0031308, light * 12.92, 1.055 * light ** (1 / 2.4) - 0.055)


def texture(image, u, v):
    """Samples a periodic image with bilinear filtering. v points down."""
    height, width = image.shape[:2]
    x, y = u * width - 0.5, v * height - 0.5
    left, top = numpy.floor(x).astype(int), numpy.floor(y).astype(int)
    fx, fy = (x - left)[..., None], (y - top)[..., None]

    def texel(row, column):
        return image[row % height, column % width]
    upper = texel(top, left) * (1 - fx) + texel(top, left + 1) * fx
    lower = texel(top + 1, left) * (1 - fx) + texel(top + 1, left + 1) * fx
    return upper * (1 - fy) + lower * fy


def blended(first, second, motion_map, weight, multiplier):
    """The shader's moment_at and blended: both frames are moved along the motion of the earlier one, and mixed."""
    height, width = first.shape[:2]
    u, v = numpy.meshgrid((numpy.arange(width) + 0.5) / width, (numpy.arange(height) + 0.5) / height)
    motion = (texture(motion_map, u, v)[..., :2] * 2 - 1) * multiplier
    du, dv = motion[..., 0], -motion[..., 1] * width / height
    earlier = texture(first, u - weight * du, v - weight * dv)
    later = texture(second, u + (1 - weight) * du, v + (1 - weight) * dv)
    return earlier * (1 - weight) + later * weight


class Loops:
    """A loop of N frames, and the same loop of 2 N frames: frame k of the first is frame 2 k - 1 of the second."""

    def __init__(self, folder, preset):
        self.folder, self.preset = folder, preset
        baked = json.loads((folder / "coarse/manifest.json").read_text(encoding="utf-8"))["sets"][-1]
        self.count = baked["loop"]["period"]
        self.multiplier = baked["conventions"]["motion_multiplier"]

    def read(self, loop, name, frame):
        return read_samples(self.folder / loop / f"{self.preset}_{name}.{frame:04d}.png")

    def differences(self, frame):
        """Returns differences in codes at the frame, and halfway to the next frame: cross-fade and blending."""
        first = self.read("coarse", "albedo", frame)
        second = self.read("coarse", "albedo", frame % self.count + 1)
        halfway = self.read("fine", "albedo", 2 * frame)
        motion = self.read("coarse", "motion", frame)
        same = mean_difference(first, self.read("fine", "albedo", 2 * frame - 1))
        fade = encoded((linear(first) + linear(second)) / 2)
        moved = encoded(blended(linear(first), linear(second), motion, 0.5, self.multiplier))
        return same, mean_difference(fade, halfway), mean_difference(moved, halfway)


def mean_difference(a, b):
    return float(numpy.abs(a - b).mean() * 255)


def main():
    loops = Loops(pathlib.Path(sys.argv[1]), sys.argv[2])
    rows = [loops.differences(frame) for frame in range(1, loops.count + 1)]
    same, fade, moved = (float(column) for column in numpy.mean(rows, axis=0))
    print(f"{loops.preset}: {loops.count} frames, cross-fade {fade:.2f}, blended along the motion {moved:.2f}")
    if same > 0:
        print(f"{loops.preset}: the two loops show different foams, by {same:.2f} of 255", file=sys.stderr)
    return 1 if same > 0 else 0


if __name__ == "__main__":
    sys.exit(main())
