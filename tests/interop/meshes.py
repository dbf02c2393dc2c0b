#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads meshes of foamtex: STL with admesh, which must find a closed surface and nothing to repair, and GLB directly.
Volumes are compared with those that follow from other files of the same frame: the areas of walls from the arcs of a
DXF file, which ezdxf reads, and the heights of a relief from a PNG.

Usage: tests/interop/meshes.py PROGRAM SCRATCH
"""
import json
import math
import re
import struct
import subprocess
import sys

import ezdxf
import numpy
from PIL import Image

FRAME = ["frames.count=1", "loop.kind=none", "loop.current=0", "frames.warm_up=0"]
WIDTH = 90.0
BASE = 1.5
WALL = 4.0
TOLERANCE = 0.01
# Preset, map, border, base. The plate of a tile that is cut has the area of the tile.
WALLS = [("maze", "maze", "cut", 0), ("maze", "maze", "cut", BASE), ("maze", "maze", "whole", 0),
         ("stained_glass", "albedo", "cut", BASE), ("soap_raft", "albedo", "cut", 0), ("labyrinth", "contour", "cut", BASE)]
# Presets with plates that have no simple area are only read, not measured.
PLATES = [("maze", "maze", "whole"), ("soap_raft", "albedo", "cut"), ("soap_raft", "maze", "cut")]
RELIEFS = ["pebbles", "soap_raft", "sea_foam", "maze_relief"]
PIXELS = 256
# Lines of the report of admesh, all of which must be 0.
FAULTS = ["Total disconnected facets", "Degenerate facets", "Edges fixed", "Facets removed", "Facets added",
          "Facets reversed", "Backwards edges", "Normals fixed"]


def run(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def bake(program, preset, what, out, *settings):
    sets = [part for setting in (*FRAME, *settings) for part in ("--set", setting)]
    run(program, "bake", preset, "--maps", what, "--frames", "1", "--size", str(PIXELS), "--out", out, "-q", *sets)


def admesh(path):
    """Returns the volume of a closed mesh, or exits."""
    report = run("admesh", path)
    for fault in FAULTS:
        numbers = [int(number) for number in re.search(re.escape(fault) + r"\s*:([\s\d]+)$", report, re.M)[1].split()]
        if any(numbers):
            sys.exit(f"meshes.py: error: {path}: {fault}: {numbers}")
    return float(re.search(r"Volume\s*:\s*(\S+)", report)[1])


def glb_volume(path):
    """Returns the volume of a GLB in cubic millimeters. Exits if its surface is not closed."""
    with open(path, "rb") as file:
        data = file.read()
    size = struct.unpack_from("<I", data, 12)[0]
    gltf, binary = json.loads(data[20:20 + size]), data[28 + size:]

    def array(index, kind, components):
        accessor = gltf["accessors"][index]
        view = gltf["bufferViews"][accessor["bufferView"]]
        return numpy.frombuffer(binary, kind, accessor["count"] * components, view["byteOffset"]).reshape(-1, components)

    primitive = gltf["meshes"][0]["primitives"][0]
    positions = array(primitive["attributes"]["POSITION"], "<f4", 3)
    corners = array(primitive["indices"], "<u4", 1).reshape(-1, 3)
    points, merged = numpy.unique(positions, axis=0, return_inverse=True)
    triangles = merged.reshape(-1)[corners]
    edges = numpy.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    forward = numpy.unique(edges, axis=0)
    backward = numpy.unique(edges[:, ::-1], axis=0)
    if len(forward) != len(edges) or not numpy.array_equal(forward, backward):
        sys.exit(f"meshes.py: error: {path} is not closed")
    a, b, c = (points[triangles[:, k]].astype(float) for k in range(3))
    return numpy.einsum("ij,ij->", a, numpy.cross(b, c)) / 6 * 1e9


def wall_area(path):
    """Returns the area inside of the outlines of a DXF file and their length, from their arcs."""
    area = length = 0.0
    for line in ezdxf.readfile(path).modelspace().query("LWPOLYLINE"):
        points = [(x, y, bulge) for x, y, _, _, bulge in line.get_points()]
        for (x, y, bulge), (u, v, _) in zip(points, points[1:] + points[:1]):
            angle = 4 * math.atan(bulge)
            chord = math.hypot(u - x, v - y)
            radius = chord / (2 * math.sin(angle / 2)) if bulge else 0.0
            area += (x * v - u * y) / 2 + radius * radius * (angle - math.sin(angle)) / 2
            length += abs(radius * angle) if bulge else chord
    return area, length


def both(program, preset, what, base, *settings):
    """Bakes both formats and returns the volume in the STL. Exits if the volumes differ."""
    settings = (*settings, f"vector.width_mm={WIDTH}")
    for suffix in (".stl", ".glb"):
        bake(program, preset, what, base + suffix, *settings)
    volume, other = admesh(base + ".stl"), glb_volume(base + ".glb")
    if abs(volume / other - 1) > 1e-3:
        sys.exit(f"meshes.py: error: {base}: volumes {volume} and {other}")
    return other


def compare(name, volume, expected, allowed):
    print(f"{name}: {volume:.2f} mm³, expected {expected:.2f}, differs by {abs(volume - expected):.2f} of {allowed:.2f}")
    return abs(volume - expected) <= allowed


def walls(program, folder, preset, what, wrap, plate):
    name = f"{preset}_{what}_{wrap}_{plate}"
    base = f"{folder}/{name}"
    shape = [f"vector.content={'foam' if what == 'albedo' else what}", "vector.wall_width=0.6"]
    shape += [] if preset == "soap_raft" else ["vector.wrap=" + wrap]
    volume = both(program, preset, what, base, "mesh.kind=walls", f"mesh.base_mm={plate}", f"mesh.wall_mm={WALL}",
                  f"mesh.tolerance_mm={TOLERANCE}", *shape)
    bake(program, preset, what, base + ".dxf", "vector.walls=outlines", f"vector.width_mm={WIDTH}", *shape)
    area, length = wall_area(base + ".dxf")
    return compare(name, volume, area * WALL + WIDTH * WIDTH * plate, length * TOLERANCE * WALL)


def relief(program, folder, preset):
    base = f"{folder}/{preset}_relief"
    volume = both(program, preset, "height", base, "mesh.kind=relief", f"mesh.base_mm={BASE}")
    bake(program, preset, "height", base + ".png", "height.full=2")
    with open(f"{folder}/manifest.json", encoding="utf-8") as file:
        sets = json.load(file)["sets"]
    displacement = next(file["displacement"] for entry in sets for file in entry["files"] if "displacement" in file
                        and file["path"] == f"{preset}_relief.png")
    heights = numpy.asarray(Image.open(base + ".png"), dtype=float) / 65535 * displacement * WIDTH
    expected = WIDTH * WIDTH * (BASE + heights.mean() - heights.min())
    return compare(f"{preset} relief", volume, expected, 0.002 * expected)


def main():
    program, folder = sys.argv[1:]
    results = [walls(program, folder, *case) for case in WALLS]
    results += [relief(program, folder, preset) for preset in RELIEFS]
    for preset, what, wrap in PLATES:
        shape = [] if preset == "soap_raft" else ["vector.wrap=" + wrap]
        volume = both(program, preset, what, f"{folder}/{preset}_{what}_{wrap}_plate", "mesh.kind=walls",
                      "vector.wall_width=0.6", *shape)
        print(f"{preset} {what} {wrap} on a plate: {volume:.2f} mm³")
    if not all(results):
        sys.exit("meshes.py: error: a volume is not as expected")


main()
