# SPDX-License-Identifier: Apache-2.0
"""Finds and draws the films, bubbles and half-edges of a foam that a figure shows."""
import cmath
import math

from cached_states import twin
from canvas import ARROW_HEAD, THIN

SAMPLES = 60  # steps per side of the grid of positions that are tried for a label
SIDE = 8  # pixels between a film and the arrow of a half-edge
ASPECT = 2  # width of a label divided by its height
PER_ARC = 12  # number of points that represent an arc


def draw_half_edge(canvas, view, arc, color, width=THIN + 0.5):
    """Draws a half-edge as an arrow beside its film, in the bubble on its left."""
    side = SIDE / view.scale
    trim = (SIDE + 4) / view.scale / arc.length
    beside = arc.part(trim, 1 - trim).beside(side)
    shaft = 1 - 0.7 * ARROW_HEAD / view.scale / beside.length
    canvas.path(view.path([beside.part(0, shaft)]), stroke=color, width=width)
    tip, before = view.at(beside.head), view.at(beside.point_at(1 - ARROW_HEAD / view.scale / beside.length))
    canvas.arrow_head(tip, tip - before, color)


def copies(state):
    """Returns the translations of the cell of a torus to itself and the eight copies around it; for a patch, only 0."""
    if state.periods == 0:
        return [0j]
    return [state.translation((i, j)) for j in (-1, 0, 1) for i in (-1, 0, 1)]


def points_of(arcs):
    """Returns points along arcs, which represent the arcs."""
    return [arc.point_at(index / PER_ARC) for arc in arcs for index in range(PER_ARC)]


def outline_near(state, identity, center):
    """Returns the outline of the copy of a bubble that is nearest to a point."""
    outline = state.outline(state.first[state.bubble(identity)])
    points = points_of(outline)
    middle = sum(points) / len(points)
    by = min(copies(state), key=lambda translation: abs(middle + translation - center))
    return [arc.moved(by) for arc in outline]


def films_near(state, center, radius):
    """Returns the arcs of all films, including copies, that have a part within a distance `radius` of a point."""
    found = []
    for half_edge in range(0, 2 * len(state.offsets), 2):
        arc = state.arc(half_edge)
        for by in copies(state):
            if min(abs(point + by - center) for point in points_of([arc]) + [arc.head]) < radius:
                found.append(arc.moved(by))
    return found


def film_between(state, a, b, center):
    """Returns the film between two bubbles that is nearest to a point. The first bubble is on its left."""
    left, right = state.bubble(a), state.bubble(b)
    arcs = [state.arc(half_edge).moved(by) for half_edge in sorted(state.next) for by in copies(state)
            if state.left.get(half_edge) == left and state.left.get(twin(half_edge)) == right]
    if not arcs:
        raise ValueError(f"frame {state.number}: there is no film between the bubbles {a} and {b}")
    return min(arcs, key=lambda arc: abs(arc.point_at(0.5) - center))


def is_inside(point, polygon):
    """Returns true if a ray from the point to the right crosses a closed polygon an odd number of times."""
    inside = False
    for a, b in zip(polygon, polygon[1:] + polygon[:1]):
        if (a.imag > point.imag) != (b.imag > point.imag):
            crossing = a.real + (b.real - a.real) * (point.imag - a.imag) / (b.imag - a.imag)
            inside ^= crossing > point.real
    return inside


def room_for_label(outline, center, radius):
    """Returns the point of a bubble, in a round window, with the most space around it for a label."""
    polygon = points_of(outline)
    border = [center + cmath.rect(radius, math.radians(degrees)) for degrees in range(0, 360, 5)]

    def room(point):
        if not is_inside(point, polygon):
            return 0.0
        return round(min(abs(complex((point - near).real / ASPECT, (point - near).imag)) for near in polygon + border), 6)

    steps = [radius * (2 * index / SAMPLES - 1) for index in range(SAMPLES + 1)]
    grid = [center + complex(x, y) for y in steps for x in steps if abs(complex(x, y)) < radius]
    return max(grid, key=room)
