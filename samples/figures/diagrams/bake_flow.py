# SPDX-License-Identifier: Apache-2.0
"""Draws the flow of a bake (texgen/bake), and the commands simulate and render, which are its two halves."""
from canvas import ARROW_HEAD, DASH, LABEL, MARGIN, NOTE, THIN, WIDTH, Canvas, polyline

HEIGHT = 500
BOX = 124 + 44j  # width and height of a step
SOURCE = 118  # y of the steps of the caller's thread
QUEUE = 254
DRAWING = 394
STEPS = (96, 254, 412, 570, 744)  # x of the steps


def draw_lane(canvas, top, bottom, color, title):
    """Draws the background of the steps that run on the same threads."""
    canvas.rect(complex(MARGIN, top), WIDTH - 2 * MARGIN, bottom - top, radius=10, fill=color)
    canvas.text(complex(WIDTH - MARGIN - 14, top + 20), title, size=NOTE, anchor="end", bold=True)


def draw_step(canvas, center, *lines):
    canvas.rect(center - BOX / 2, BOX.real, BOX.imag, radius=6, fill="card", stroke="ink", width=THIN)
    write_centered(canvas, center, lines)


def write_centered(canvas, center, lines):
    canvas.lines(center - 8j * (len(lines) - 1), lines, size=NOTE if len(lines) > 1 else LABEL, spacing=16)


def draw_file(canvas, center, *lines):
    """Draws a sheet of paper with a folded corner."""
    fold = 12
    low = center + BOX / 2
    high = low - 1j * BOX.imag
    corners = [high - BOX.real, high - fold, high + 1j * fold, low, low - BOX.real]
    canvas.path(polyline(corners, closed=True), fill="card", stroke="ink", width=THIN)
    canvas.path(polyline([high - fold, high - fold + 1j * fold, high + 1j * fold]), stroke="ink", width=THIN)
    write_centered(canvas, center, lines)


def draw_route(canvas, points, color="ink", dash=None):
    """Draws an arrow along straight lines."""
    tip, before = points[-1], points[-2]
    end = tip - 0.75 * ARROW_HEAD * (tip - before) / abs(tip - before)
    canvas.path(polyline([*points[:-1], end]), stroke=color, width=THIN + 0.25, dash=dash)
    canvas.arrow_head(tip, tip - before, color)


def connect(canvas, y, first, last):
    """Draws the arrow from a step to the next one in the same lane."""
    draw_route(canvas, [complex(first + BOX.real / 2, y), complex(last - BOX.real / 2, y)])


def draw_loop(canvas, y, first, last, title):
    """Draws an arrow from a step back to an earlier step, below both."""
    bottom = y + BOX.imag / 2
    draw_route(canvas, [complex(last, bottom), complex(last, bottom + 20), complex(first, bottom + 20),
                        complex(first, bottom)], "muted")
    canvas.text(complex((first + last) / 2, bottom + 33), title, size=NOTE, color="muted")


def draw_source(canvas):
    """Draws the steps of the caller's thread."""
    draw_lane(canvas, MARGIN, 190, "neutral", "the caller’s thread")
    draw_file(canvas, complex(STEPS[0], SOURCE), "preset")
    draw_step(canvas, complex(STEPS[1], SOURCE), "seed foam")
    draw_step(canvas, complex(STEPS[2], SOURCE), "step")
    draw_step(canvas, complex(STEPS[3], SOURCE), "snapshot")
    for first, last in zip(STEPS[:3], STEPS[1:4]):
        connect(canvas, SOURCE, first, last)
    draw_loop(canvas, SOURCE, STEPS[2], STEPS[3] - 24, "for each frame")


def draw_cache(canvas):
    """Draws the cache, which simulate writes and render reads."""
    x = STEPS[4]
    draw_file(canvas, complex(x, SOURCE), "cache:", "one file per state")
    draw_route(canvas, [complex(STEPS[3] + BOX.real / 2, SOURCE), complex(x - BOX.real / 2, SOURCE)], "blue")
    canvas.text(complex((STEPS[3] + x) / 2, SOURCE - 34), "simulate", color="blue")
    draw_route(canvas, [complex(x, SOURCE + BOX.imag / 2), complex(x, QUEUE), complex(602, QUEUE)], "green")
    canvas.text(complex(x - 70, QUEUE - 14), "render", color="green")


def draw_queue(canvas):
    """Draws the bounded queue between the caller's thread and the drawing threads."""
    slot = 34
    for index in range(4):
        corner = complex(600 - slot * (index + 1), QUEUE - slot / 2)
        canvas.rect(corner, slot, slot, fill="card", stroke="ink", width=THIN)
        if index >= 1:
            canvas.rect(corner + 8 + 8j, slot - 16, slot - 16, radius=2, fill="muted")
    draw_route(canvas, [complex(STEPS[3], SOURCE + BOX.imag / 2), complex(STEPS[3], QUEUE - slot / 2 - 1)])
    canvas.text(complex(STEPS[3] + 12, 212), "bake", anchor="start")
    canvas.lines(complex(452, QUEUE - 36), ["queue of frames: at most two", "per drawing thread wait"], anchor="end")
    entry = STEPS[0] + 24
    draw_route(canvas, [complex(600 - 4 * slot, QUEUE), complex(entry, QUEUE),
                        complex(entry, DRAWING - BOX.imag / 2)])


def draw_help_of_caller(canvas):
    """Draws the arrow of frames that the caller's thread draws itself."""
    x = STEPS[0] - 24
    draw_route(canvas, [complex(x, 190), complex(x, DRAWING - BOX.imag / 2)], dash=DASH)
    canvas.lines(complex(x + 12, 214), ["if the queue is full,", "the caller draws, too"], anchor="start")


def draw_drawing(canvas):
    """Draws the steps of the drawing threads."""
    draw_lane(canvas, 310, HEIGHT - MARGIN, "neutral", "drawing threads, one frame each")
    draw_step(canvas, complex(STEPS[0], DRAWING), "draw")
    draw_step(canvas, complex(STEPS[1], DRAWING), "quantize")
    draw_step(canvas, complex(STEPS[2], DRAWING), "encode")
    draw_file(canvas, complex(STEPS[3], DRAWING), "image file")
    draw_file(canvas, complex(STEPS[4], DRAWING), "manifest.json")
    for first, last in zip(STEPS, STEPS[1:]):
        connect(canvas, DRAWING, first, last)
    draw_loop(canvas, DRAWING, STEPS[0], STEPS[3], "for each map (an EXR without {map} has all maps as layers)")


def bake_flow():
    canvas = Canvas(HEIGHT, "The flow of a bake",
                    "The caller's thread seeds the foam of a preset, steps it and takes a snapshot of each frame. A "
                    "bounded queue hands the frames to the drawing threads, which draw, quantize, encode and write each "
                    "map. The command simulate writes the states into a cache instead; render draws frames of the cache.")
    draw_source(canvas)
    draw_drawing(canvas)
    draw_cache(canvas)
    draw_queue(canvas)
    draw_help_of_caller(canvas)
    return canvas
