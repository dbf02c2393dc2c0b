# SPDX-License-Identifier: Apache-2.0
"""Draws the libraries of core and texgen, called rooms, as a graph.

The rooms are read from the calls of foam_room in the CMakeLists.txt files.
"""
import pathlib
import re

from canvas import MARGIN, NOTE, THIN, WIDTH, Canvas, pair
from layers import is_bend, make_layers, place, reduce_crossings

ROOT = pathlib.Path(__file__).resolve().parents[3]
BOX = 100 + 30j  # width and height of a room
PITCH = 64  # distance between layers
TOP = 104
KEYWORDS = r"SOURCES|USES|PUBLIC_LIBRARIES|LIBRARIES"
# The prefixes of folders, the longest first, with their colors and their texts in the legend.
GROUPS = (("texgen/raster/", "green-tint", "texgen/raster/…"),
          ("texgen/", "orange-tint", "texgen/…"),
          ("core/", "blue-tint", "core/…"))


def read_rooms():
    """Returns, for the folder of each room, the folders of the rooms that it uses."""
    uses = {}
    for top in ("core", "texgen"):
        for file in sorted(ROOT.glob(f"{top}/**/CMakeLists.txt")):
            call = re.search(r"^foam_room\((\S+)(.*?)\)", file.read_text(encoding="utf-8"), re.M | re.S)
            if call:
                found = re.search(rf"\bUSES\b(.*?)(?=\b(?:{KEYWORDS})\b|\Z)", call[2], re.S)
                uses[call[1]] = found[1].split() if found else []
    return uses


def without_shortcuts(uses):
    """Leaves out the rooms that a room also uses through others (the transitive reduction)."""
    def seen_from(room):
        return set(uses[room]).union(*(seen_from(used) for used in uses[room]))

    return {room: [used for used in direct if not any(used in seen_from(other) for other in direct)]
            for room, direct in uses.items()}


def gap(a, b):
    """Returns the distance between the centers of two adjacent nodes of a row."""
    return sum(12 if is_bend(node) else BOX.real / 2 + 11 for node in (a, b))


def group_of(room):
    return next(group for group in GROUPS if room.startswith(group[0]))


def positions(layers):
    """Returns the center of every node in pixels. The map is in the middle of the figure."""
    x = place(layers, gap)
    shift = WIDTH / 2 - (min(x.values()) + max(x.values())) / 2
    return {node: complex(x[node] + shift, TOP + PITCH * index)
            for index, row in enumerate(layers.rows) for node in row}


def draw_arrow(canvas, points):
    """Draws a curve through the nodes of an arrow, from the top of a room to the bottom of the room that it uses."""
    half = BOX.imag / 2
    stops = [points[0] - 1j * half]
    for bend in points[1:-1]:
        stops += [bend + 1j * half, bend - 1j * half]
    stops.append(points[-1] + 1j * (half + 2))
    tip = stops[-1]
    stops[-1] = tip + 7j
    data = "M" + pair(stops[0])
    for index, (a, b) in enumerate(zip(stops, stops[1:])):
        if index % 2 == 1:
            data += "L" + pair(b)
        else:
            bend = 0.5j * (a.imag - b.imag)
            data += f"C{pair(a - bend)} {pair(b + bend)} {pair(b)}"
    canvas.path(data, stroke="muted", width=THIN)
    canvas.arrow_head(tip, -1j, "muted", length=9)


def draw_room(canvas, room, center):
    prefix, color, _ = group_of(room)
    canvas.rect(center - BOX / 2, BOX.real, BOX.imag, radius=6, fill=color, stroke="muted", width=THIN)
    canvas.text(center, room.removeprefix(prefix), size=NOTE)


def draw_legend(canvas):
    left = MARGIN
    for _, color, label in reversed(GROUPS):
        canvas.rect(complex(left, MARGIN), 28, 18, radius=4, fill=color, stroke="muted", width=THIN)
        canvas.text(complex(left + 38, MARGIN + 9), label, size=NOTE, anchor="start")
        left += 70 + 8 * len(label)


def draw_note(canvas):
    canvas.lines(complex(WIDTH - MARGIN, MARGIN + 9), ["An arrow points to a room that is used. A room",
                                                       "sees all rooms that its arrows lead to."],
                 anchor="end", color="muted")


def rooms():
    layers = make_layers(without_shortcuts(read_rooms()))
    reduce_crossings(layers)
    at = positions(layers)
    height = TOP + PITCH * (len(layers.rows) - 1) + BOX.imag / 2 + MARGIN
    canvas = Canvas(height, "The rooms of foamtex",
                    "The folders of core and texgen as a graph. " + " ".join(
                        f"{room} uses {', '.join(used) or 'no other room'}." for room, used in read_rooms().items()))
    draw_legend(canvas)
    draw_note(canvas)
    for chain in layers.chains.values():
        draw_arrow(canvas, [at[node] for node in chain])
    for room in read_rooms():
        draw_room(canvas, room, at[room])
    return canvas
