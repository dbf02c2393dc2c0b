# SPDX-License-Identifier: Apache-2.0
"""Draws a patch that is closed by the ghost bubble."""
from arcs import View
from cached_states import read_state
from canvas import FILM, MARGIN, Canvas
from window import draw_half_edge, points_of

HEIGHT = 440
PANEL = 504  # width of the part of the plane that is shown
INSET = 34  # distance between the raft and the border of the panel
TITLE = 28  # additional space above the raft, for the name of the ghost
LEGEND = MARGIN + PANEL + 28  # left end of the texts


def outer_boundary(state):
    """Returns the half-edges of the ghost around the raft, in their order."""
    return state.around(state.ghost_sides()[0])


def inner_bubble(state):
    """Returns the largest bubble that touches only other bubbles."""
    inner = [bubble for bubble, first in enumerate(state.first)
             if not any(state.is_outer(side) for side in state.around(first))]
    return max(inner, key=lambda bubble: state.target_areas[bubble])


def draw_raft(canvas, state, view):
    """Draws the ghost as the background, and the raft on it."""
    canvas.rect(MARGIN * (1 + 1j), PANEL, HEIGHT - 2 * MARGIN, radius=8, fill="orange-tint")
    boundary = state.outline(outer_boundary(state)[0])
    canvas.path(view.path(boundary, closed=True), fill="card")
    canvas.path(view.path(state.outline(state.first[inner_bubble(state)]), closed=True), fill="blue-tint")
    films = [state.arc(half_edge) for half_edge in range(0, 2 * len(state.offsets), 2)]
    canvas.path("".join(view.path([film]) for film in films), stroke="ink")
    for junction in state.positions:
        canvas.dot(view.at(junction), radius=3.5)


def draw_half_edges(canvas, state, view):
    for half_edge in outer_boundary(state):
        draw_half_edge(canvas, view, state.arc(half_edge), "orange")
    for half_edge in state.around(state.first[inner_bubble(state)]):
        draw_half_edge(canvas, view, state.arc(half_edge), "blue")


def write_legend(canvas):
    """Writes the meaning of the colors, and a note on the ghost."""
    y = MARGIN + 24
    for color, lines in (("orange", ["half-edges of the ghost:", "the ghost is on their left"]),
                         ("blue", ["half-edges of a bubble:", "counter-clockwise around it"]),
                         ("ink", ["film: a bubble on each side,", "or a bubble and the ghost"])):
        if color == "ink":
            canvas.line(complex(LEGEND, y), complex(LEGEND + 30, y), width=FILM)
        else:
            canvas.arrow(complex(LEGEND, y), complex(LEGEND + 30, y), color)
        canvas.lines(complex(LEGEND + 42, y), lines, anchor="start")
        y += 18 * len(lines) + 22
    canvas.dot(complex(LEGEND + 15, y))
    canvas.lines(complex(LEGEND + 42, y), ["junction: three films,", "also at the free surface"], anchor="start")
    canvas.lines(complex(LEGEND, y + 76), ["The solver has no unknown and no", "equation for the ghost."], anchor="start")


def view_of(state):
    """Returns the view in which the raft fits the panel."""
    points = points_of(state.outline(outer_boundary(state)[0]))
    low = complex(min(z.real for z in points), min(z.imag for z in points))
    high = complex(max(z.real for z in points), max(z.imag for z in points))
    size = high - low
    scale = min((PANEL - 2 * INSET) / size.real, (HEIGHT - 2 * MARGIN - 2 * INSET - TITLE) / size.imag)
    return View(scale, complex(MARGIN + PANEL / 2, (HEIGHT + TITLE) / 2), (low + high) / 2)


def ghost_bubble(states):
    state = read_state(states / "patch", 1)
    canvas = Canvas(HEIGHT, "A patch closed by the ghost bubble",
                    "A raft of bubbles in the plane. Everything around it is one more bubble, the ghost, whose half-edges "
                    "go clockwise around the raft, so that the ghost is on their left.")
    view = view_of(state)
    draw_raft(canvas, state, view)
    draw_half_edges(canvas, state, view)
    canvas.text(complex(MARGIN + 18, MARGIN + 24), "ghost bubble: pressure 0, infinite area", color="orange",
                anchor="start")
    write_legend(canvas)
    return canvas
