#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads vector files of foamtex with programs of others: SVG with rsvg-convert and xmllint, PDF with pdftoppm, DXF with
ezdxf, and SVG with Inkscape if it is installed. Renderings are compared with PNGs of the map albedo, maze or contour.

Usage: tests/interop/vectors.py PROGRAM SCRATCH
"""
import json
import shutil
import subprocess
import sys

import ezdxf
import numpy
from PIL import Image

# Both pictures are reduced before they are compared, because renderers mix the colors of a pixel as sRGB codes, while
# foamtex mixes light.
PIXELS = 2048
REDUCTION = 8
# Limits of the mean and of the largest difference, of 255.
LIMITS = {"rsvg-convert": (1.5, 20), "inkscape": (1.5, 20), "pdftoppm": (2.0, 30)}

# Preset, content, settings. Films of a constant width and without shade or grain, so that an image shows what a drawing
# can show.
PLAIN = ["albedo.shade=0", "albedo.grain=0", "albedo.film_profile=even", "albedo.film_unit=px", "albedo.film_width=12",
         "frames.count=1", "loop.kind=none", "loop.current=0", "frames.warm_up=0"]
CASES = [("stained_glass", "albedo", "lines"), ("stained_glass", "albedo", "outlines"), ("soap_raft", "albedo", "lines"),
         ("maze", "maze", "lines"), ("maze", "maze", "outlines"), ("maze", "maze_solution", "outlines"),
         ("labyrinth", "contour", "lines")]


def run(*command):
    return subprocess.run(command, check=True, capture_output=True).stdout


def bake(program, preset, what, out, *settings):
    sets = [part for setting in (*PLAIN, *settings) for part in ("--set", setting)]
    run(program, "bake", preset, "--maps", what, "--frames", "1", "--size", str(PIXELS), "--out", out, "-q", *sets)


def picture(path):
    """Returns a picture over white as an array of numbers, reduced to means of squares of pixels."""
    pixels = numpy.asarray(Image.open(path).convert("RGBA"), dtype=float)
    alpha = pixels[..., 3:] / 255
    shown = alpha * pixels[..., :3] + (1 - alpha) * 255
    side = PIXELS // REDUCTION
    return shown.reshape(side, REDUCTION, side, REDUCTION, 3).mean(axis=(1, 3))


def compare(name, reader, ours, other):
    difference = numpy.abs(picture(ours) - picture(other))
    mean, largest = difference.mean(), difference.max()
    print(f"{name}, {reader}: differs from the PNG by {mean:.3f} of 255 on average, by at most {largest:.1f}")
    return mean <= LIMITS[reader][0] and largest <= LIMITS[reader][1]


def svg_and_pdf(program, folder, preset, what, walls):
    base = f"{folder}/{preset}_{what}_{walls}"
    setting = f"vector.walls={walls}"
    bake(program, preset, what, base + ".png")
    bake(program, preset, what, base + ".svg", setting)
    bake(program, preset, what, base + ".pdf", setting)
    run("xmllint", "--noout", base + ".svg")
    run("rsvg-convert", "--width", str(PIXELS), "--output", base + "_svg.png", base + ".svg")
    run("pdftoppm", "-png", "-singlefile", "-scale-to", str(PIXELS), base + ".pdf", base + "_pdf")
    name = f"{preset} {what} {walls}"
    results = [compare(name, "rsvg-convert", base + ".png", base + "_svg.png"),
               compare(name, "pdftoppm", base + ".png", base + "_pdf.png")]
    if shutil.which("inkscape"):
        run("inkscape", "--export-width", str(PIXELS), "--export-filename", base + "_inkscape.png", base + ".svg")
        results.append(compare(name, "inkscape", base + ".png", base + "_inkscape.png"))
    return results


def arcs_of(document, layer):
    """Returns the number of arcs of a layer: the segments of its polylines."""
    count = 0
    for line in document.modelspace().query(f'LWPOLYLINE[layer=="{layer}"]'):
        count += len(line) if line.closed else len(line) - 1
    return count


def dxf(program, folder, preset, wrap):
    base = f"{folder}/{preset}_{wrap}"
    bake(program, preset, "albedo", base + ".dxf", "vector.wrap=" + wrap)
    bake(program, preset, "albedo", base + ".json")
    with open(base + ".json", encoding="utf-8") as file:
        tables = json.load(file)
    document = ezdxf.readfile(base + ".dxf")
    errors = document.audit().errors
    arcs = arcs_of(document, "films")
    points = len(document.modelspace().query("POINT"))
    lone = sum(bubble["sides"] == 0 for bubble in tables["bubbles"])
    films = len(tables["films"]) + 2 * lone
    chains = len(document.modelspace().query("LWPOLYLINE"))
    print(f"{preset}, {wrap}: ezdxf finds {len(errors)} errors, {arcs} arcs in {chains} chains for {films} films, "
          f"{points} points for {len(tables['junctions'])} junctions")
    is_exact = tables["domain"] is None
    return [not errors, arcs == films if is_exact else arcs > films, points == len(tables["junctions"]),
            document.header["$INSUNITS"] == 4, chains < arcs]


def main():
    program, folder = sys.argv[1:]
    results = []
    for case in CASES:
        results += svg_and_pdf(program, folder, *case)
    for preset, wrap in (("soap_raft", "cut"), ("stained_glass", "cut"), ("stained_glass", "whole")):
        results += dxf(program, folder, preset, wrap)
    if not all(results):
        sys.exit("vectors.py: error: a file was not read as expected")


main()
