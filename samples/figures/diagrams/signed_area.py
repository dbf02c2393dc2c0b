# SPDX-License-Identifier: Apache-2.0
"""Draws the contributions of an arc to the pixels of a row (texgen/raster/coverage)."""
import math

from arcs import Arc, View
from canvas import DASH, LABEL, MARGIN, NOTE, THIN, WIDTH, Canvas

# The arc in one row of pixels, in pixels. It enters through the lower border and leaves through the upper border.
ARC = Arc(1.42 + 0j, 3.44 + 1j, math.radians(16))
COLUMNS = 6
ZOOMED = 1  # index of the part that the upper half shows
ZOOM = 200  # size of a pixel in the upper half
ZOOM_CORNER = complex(92, 258)  # lower left corner of the pixel there
SIZE = 104  # size of a pixel in the lower half
LEFT = WIDTH - MARGIN - COLUMNS * SIZE  # left end of the row in the lower half
ROW_BOTTOM = 426
LINE = 30  # distance between the lines of the table
HEIGHT = ROW_BOTTOM + 6 * LINE + 16


def cut(arc, x):
    """Returns the fraction of the arc's length at which it crosses a border between columns."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if arc.point_at(middle).real < x else (low, middle)
    return low


def parts_of(arc):
    """Returns the parts of the arc, one per pixel, with their columns."""
    first, last = math.floor(arc.tail.real), math.floor(arc.head.real)
    cuts = [0.0, *(cut(arc, x) for x in range(first + 1, last + 1)), 1.0]
    return [(first + index, arc.part(a, b)) for index, (a, b) in enumerate(zip(cuts, cuts[1:]))]


def height_of(part):
    return part.chord.imag


def area_on_left(column, part):
    """Returns the area in the pixel to the left of a part: beside its chord, and in the segment beyond it (E1)."""
    trapezoid = height_of(part) * ((part.tail + part.head).real / 2 - column)
    sine, cosine = math.sin(part.half_angle), math.cos(part.half_angle)
    return trapezoid + abs(part.chord) ** 2 / 4 * (part.half_angle - sine * cosine) / sine ** 2


def contributions(column, part):
    """Returns the amounts that a part adds to the differences, by column."""
    on_left = area_on_left(column, part)
    return {column: height_of(part) - on_left, column + 1: on_left}


def draw_zoom(canvas):
    """Draws one part in its pixel, with the next pixel on its right."""
    column, part = parts_of(ARC)[ZOOMED]
    part = part.moved(-column)
    view = View(ZOOM, ZOOM_CORNER)
    low, high = part.tail.imag * 1j, part.head.imag * 1j
    canvas.path(view.path([part, Arc(part.head, part.tail.real + high), Arc(part.tail.real + high, part.tail)]),
                fill="blue-tint")
    canvas.path(view.path([part, Arc(part.head, 2 + high), Arc(2 + high, 2 + low), Arc(2 + low, part.tail)]),
                fill="orange-tint")
    for corner in (1j, 1 + 1j):
        canvas.rect(view.at(corner), ZOOM, ZOOM, stroke="muted", width=THIN)
    canvas.line(view.at(part.tail), view.at(part.head), stroke="muted", width=THIN, dash=DASH)
    canvas.path(view.path([part]), stroke="ink")
    canvas.dot(view.at(part.tail))
    canvas.dot(view.at(part.head))
    label_zoom(canvas, view, part)


def label_zoom(canvas, view, part):
    low, high = part.tail.imag, part.head.imag
    canvas.arrow(view.at(-0.11 + 1j * low), view.at(-0.11 + 1j * high), "ink", both=True)
    canvas.text(view.at(-0.17 + 0.5j * (low + high)), "height", anchor="end", size=NOTE)
    canvas.text(view.at(0.06 + 1j * (high - 0.09)), "on left", color="blue", anchor="start")
    canvas.text(view.at(1.5 + 0.5j * (low + high)), "height", color="orange")
    canvas.text(view.at(0.94 + 1j * (low + 0.07)), "height − on left", color="orange", anchor="end", size=NOTE)
    canvas.text(view.at(0.5 + 1.09j), "pixel of the part", size=NOTE, color="muted")
    canvas.text(view.at(1.5 + 1.09j), "next pixel", size=NOTE, color="muted")


def write_rule(canvas):
    """Writes the contribution of a part, beside the enlarged pixel."""
    left = ZOOM_CORNER.real + 2 * ZOOM + 36
    middle = ZOOM_CORNER.imag - 0.5 * ZOOM
    canvas.lines(complex(left, middle - 86), ["An arc changes the value across it:",
                                              "across = value right − value left."], anchor="start")
    canvas.text(complex(left, middle - 34), "The part in a pixel adds", size=NOTE, anchor="start")
    canvas.text(complex(left, middle - 8), "(height − on left) · across", color="orange", anchor="start")
    canvas.text(complex(left, middle + 14), "to the difference of its pixel,", size=NOTE, anchor="start")
    canvas.text(complex(left, middle + 42), "on left · across", color="blue", anchor="start")
    canvas.text(complex(left, middle + 64), "to that of the next pixel: together,", size=NOTE, anchor="start")
    canvas.text(complex(left, middle + 82), "height · across for all on the right.", size=NOTE, anchor="start")


def center_of(column):
    return LEFT + (column + 0.5) * SIZE


def draw_row(canvas):
    """Draws the whole arc in its row of pixels."""
    view = View(SIZE, complex(LEFT, ROW_BOTTOM))
    canvas.path(view.path([ARC, Arc(ARC.head, COLUMNS + 1j), Arc(COLUMNS + 1j, COLUMNS + 0j),
                           Arc(COLUMNS + 0j, ARC.tail)]), fill="green-tint")
    for column in range(COLUMNS):
        canvas.rect(view.at(column + 1j), SIZE, SIZE, stroke="muted", width=THIN)
    canvas.path(view.path([ARC]), stroke="ink")
    for _, part in parts_of(ARC):
        canvas.dot(view.at(part.tail))
    canvas.dot(view.at(ARC.head))
    canvas.text(view.at(0.5 + 0.5j), "value 0")
    canvas.text(view.at(4.5 + 0.5j), "value 1")
    canvas.lines(complex(MARGIN, ROW_BOTTOM - SIZE / 2 - 9), ["one row of pixels:", "across = 1"], anchor="start")


def write_line(canvas, line, title, values, color="ink", bold=False):
    """Writes a line of the table: a title, and values by column."""
    y = ROW_BOTTOM + LINE * (line + 0.85)
    canvas.text(complex(MARGIN, y), title, size=NOTE, anchor="start", bold=bold)
    for column, value in values.items():
        value_color = color if isinstance(color, str) else color[column]
        canvas.text(complex(center_of(column), y), f"{value:.2f}", size=LABEL, color=value_color, bold=bold)


def write_table(canvas):
    differences = dict.fromkeys(range(COLUMNS), 0.0)
    parts = parts_of(ARC)
    for line, (column, part) in enumerate(parts):
        added = contributions(column, part)
        for to, value in added.items():
            differences[to] += value
        write_line(canvas, line, f"part {line + 1} adds", added, {column: "orange", column + 1: "blue"})
    rule = ROW_BOTTOM + LINE * (len(parts) + 0.45)
    canvas.line(complex(MARGIN, rule), complex(WIDTH - MARGIN, rule), stroke="faint", width=THIN)
    write_line(canvas, len(parts) + 0.5, "difference", differences)
    running = {column: sum(differences[other] for other in range(column + 1)) for column in range(COLUMNS)}
    write_line(canvas, len(parts) + 1.5, "running sum = pixel", running, bold=True)


def signed_area():
    canvas = Canvas(HEIGHT, "Signed areas along a row of pixels",
                    "Above: the part of an arc in one pixel, its height, and the area on its left. Below: the parts of an "
                    "arc in three pixels of a row, what each adds to the differences of pixels, and the running sum "
                    "of the differences, which is the value of each pixel.")
    draw_zoom(canvas)
    write_rule(canvas)
    draw_row(canvas)
    write_table(canvas)
    return canvas
