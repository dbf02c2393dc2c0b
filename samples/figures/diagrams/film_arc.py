# SPDX-License-Identifier: Apache-2.0
"""Draws a film as a circular arc, with the symbols of E1."""
import cmath
import math

from arcs import Arc, View
from canvas import DASH, LABEL, MARGIN, NOTE, THIN, WIDTH, Canvas

CHORD = 440  # pixels, as are all lengths of this figure
HALF_ANGLE = math.radians(50)
STUB = 62  # length of the films that meet the arc at its ends
TANGENT = 120  # length of a tangent
SAGITTA = CHORD / 2 * math.tan(HALF_ANGLE / 2)
TO_CENTER = CHORD / 2 / math.tan(HALF_ANGLE)  # distance from the chord to the center of the circle
HEIGHT = 440


def turned(direction, degrees):
    return direction * cmath.exp(1j * math.radians(degrees))


def draw_other_films(canvas, view, arc):
    """Draws the beginnings of the other films at both junctions: three films meet at 120 degrees."""
    for junction, direction in ((arc.tail, arc.direction_at(0)), (arc.head, -arc.direction_at(1))):
        for degrees in (120, -120):
            end = junction + STUB * turned(direction, degrees)
            canvas.line(view.at(junction), view.at(end), stroke="faint")


def draw_angle(canvas, view, corner, first, radius, label_radius=None):
    """Marks the half angle at a corner, counter-clockwise from the direction `first`."""
    begin = corner + radius * first
    end = corner + radius * first * cmath.exp(1j * HALF_ANGLE)
    canvas.path(view.path([Arc(begin, end, HALF_ANGLE / 2)]), stroke="orange", width=THIN)
    middle = first * cmath.exp(0.5j * HALF_ANGLE)
    canvas.text(view.at(corner + (label_radius or radius + 14) * middle), "*α*", color="orange")


def draw_circle(canvas, view, arc, center):
    """Draws the center of the circle with its radii, and the axis of symmetry."""
    for end in (arc.tail, arc.head):
        canvas.line(view.at(center), view.at(end), stroke="muted", width=THIN)
    canvas.line(view.at(center), view.at(-1j * SAGITTA), stroke="muted", width=THIN, dash=DASH)
    canvas.dot(view.at(center), "muted", 3)
    canvas.text(view.at(center + 20j), "center of the circle", size=NOTE, color="muted")
    canvas.text(view.at((center + arc.head) / 2 + 12 + 14j), "*T* / *Δ*", color="muted", anchor="start")
    canvas.text(view.at((center + arc.tail) / 2 - 12 + 14j), "radius *T* / *Δ*", color="muted", anchor="end")


def draw_tangents(canvas, view, arc):
    for end, direction in ((arc.tail, arc.direction_at(0)), (arc.head, arc.direction_at(1))):
        canvas.arrow(view.at(end), view.at(end + TANGENT * direction), "orange")


def draw_frame_of_chord(canvas, view):
    """Draws the unit vectors u and n."""
    corner, unit = 296 + 158j, 56
    canvas.arrow(view.at(corner), view.at(corner + unit), "blue")
    canvas.arrow(view.at(corner), view.at(corner + 1j * unit), "blue")
    canvas.text(view.at(corner + unit + 14), "*u*", color="blue")
    canvas.text(view.at(corner + 1j * unit + 14j), "*n*", color="blue")
    canvas.lines(view.at(corner - 4 - 24j), ["*u* = *d* / *c*", "*n* = *u* turned left"], anchor="start", color="muted")


def write_equations(canvas):
    """Writes the definitions of E1 in the upper left corner."""
    canvas.lines(complex(MARGIN, MARGIN + 12), ["*Δ* = *p*_{l} − *p*_{r}", "*s* = *Δ* *c* / 2*T* = sin *α*",
                                               "*l* = *c* *α* / sin *α*"], size=LABEL, spacing=28, anchor="start")


def film_arc():
    canvas = Canvas(HEIGHT, "A film as a circular arc (E1)",
                    "A circular arc between two junctions. The chord d of length c goes from the tail to the head. The "
                    "tangents at both ends make the half angle alpha with the chord. The radius is T / Delta, the length "
                    "is l, and the segment between chord and arc has the area S.")
    view = View(1, complex(WIDTH / 2 - 10, 270))
    arc = Arc(-CHORD / 2 + 0j, CHORD / 2 + 0j, HALF_ANGLE)
    center = 1j * TO_CENTER
    canvas.path(view.path([arc], closed=True), fill="blue-tint")
    draw_other_films(canvas, view, arc)
    draw_circle(canvas, view, arc, center)
    draw_angle(canvas, view, center, -1j * cmath.exp(-1j * HALF_ANGLE), 38)
    draw_angle(canvas, view, arc.tail, cmath.exp(-1j * HALF_ANGLE), 62)
    draw_tangents(canvas, view, arc)
    canvas.line(view.at(arc.head), view.at(arc.head + TANGENT), stroke="muted", width=THIN, dash=DASH)
    draw_angle(canvas, view, arc.head, 1, 62)
    canvas.path(view.path([arc]), stroke="ink")
    canvas.arrow(view.at(arc.tail), view.at(arc.head - 5), "blue")
    canvas.dot(view.at(arc.tail))
    canvas.dot(view.at(arc.head))
    return label(canvas, view, arc)


def label(canvas, view, arc):
    canvas.text(view.at(arc.tail - 18 + 16j), "tail", anchor="end")
    canvas.text(view.at(arc.head + 4 - 26j), "head", anchor="start")
    canvas.text(view.at(14 + 16j), "chord *d*, *c* = |*d*|", color="blue", anchor="start")
    canvas.text(view.at(-14 - 46j), "area *S*", anchor="end")
    canvas.text(view.at(12 - 46j), "(*c*/2) tan(*α*/2)", size=NOTE, color="muted", anchor="start")
    canvas.text(view.at(arc.point_at(0.7) + 14 - 12j), "length *l*", anchor="start")
    canvas.text(view.at(-14 + 48j), "left bubble: *p*_{l}", anchor="end")
    canvas.text(view.at(-1j * SAGITTA - 28j), "right bubble: *p*_{r}")
    draw_frame_of_chord(canvas, view)
    write_equations(canvas)
    return canvas
