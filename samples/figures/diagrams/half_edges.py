# SPDX-License-Identifier: Apache-2.0
"""Draws half-edges, and the lattice offset of a film that crosses the border of the torus' cell."""
from arcs import View
from cached_states import read_state
from canvas import DASH, MARGIN, NOTE, THIN, Canvas
from window import copies, draw_half_edge, films_near

HEIGHT = 484
CELL = 352  # width and height of the cell in pixels
PANEL = 514 + (CELL + 36) * 1j  # width and height of the part of the plane that is shown
SHIFT = 0.1  # from the middle of the cell to the middle of the panel, to the right, in widths of the cell
LEGEND = MARGIN + PANEL.real + 26
OFFSET = (1, 0)  # lattice offset of the half-edge h of the figure
DOT = 5  # radius of a junction


def crossing_half_edge(state):
    """Returns the half-edge with the lattice offset OFFSET that is nearest to the middle of the right border."""
    border = state.periods.real + 0.5j * state.periods.imag
    found = [half_edge for half_edge in sorted(state.next) if state.offset(half_edge) == OFFSET]
    return min(found, key=lambda half_edge: abs(state.arc(half_edge).point_at(0.5) - border))


def draw_torus(canvas, state, view, half_edge):
    """Draws the foam in the cell and, paler, around it, with the bubble on the left of the half-edge."""
    canvas.clip_rect("panel", MARGIN * (1 + 1j), PANEL.real, PANEL.imag)
    cell = view.at(1j * state.periods.imag)
    canvas.clip_rect("cell", cell, CELL, CELL)
    canvas.rect(cell, CELL, CELL, fill="neutral")
    outline = state.outline(half_edge)
    for by in copies(state):
        canvas.path(view.path([arc.moved(by) for arc in outline], closed=True), fill="blue-tint", clip="panel")
    films = films_near(state, view.center, abs(PANEL) / 2 / view.scale)
    data = "".join(view.path([film]) for film in films)
    canvas.path(data, stroke="faint", clip="panel")
    canvas.path(data, stroke="ink", clip="cell")
    canvas.rect(cell, CELL, CELL, stroke="blue", width=THIN, dash=DASH)


def draw_half_edges(canvas, state, view, half_edge):
    """Draws both half-edges of the film, and the other half-edges around the bubble on the left."""
    arc = state.arc(half_edge)
    colors = {half_edge: "orange", state.next[half_edge]: "green"}
    for side, moved in zip(state.around(half_edge), state.outline(half_edge)):
        draw_half_edge(canvas, view, moved, colors.get(side, "muted"))
    draw_half_edge(canvas, view, arc.reversed(), "pink")
    beyond_border, left = arc.point_at(0.66), 1j * arc.direction_at(0.66) / view.scale
    canvas.text(view.at(beyond_border + 24 * left), "*h*", color="orange")
    canvas.text(view.at(beyond_border - 23 * left), "twin(*h*)", size=NOTE, color="pink")
    following = state.outline(half_edge)[1]
    beside = following.point_at(0.66) + 20j * following.direction_at(0.66) / view.scale
    canvas.text(view.at(beside), "next(*h*)", size=NOTE, color="green", anchor="end")


def draw_offset(canvas, state, view, half_edge):
    """Draws the film, its junctions, and the offset from its head to the copy at which the film ends."""
    arc = state.arc(half_edge)
    canvas.path(view.path([arc]), stroke="ink")
    head = arc.head - state.translation(OFFSET)
    y = view.at(0j).imag + 42
    for end in (head, arc.head):
        foot = complex(view.at(end).real, y)
        canvas.line(view.at(end), foot + 6j, stroke="blue", width=THIN)
    canvas.arrow(complex(view.at(head).real, y), complex(view.at(arc.head).real, y), "blue")
    canvas.text(complex(view.at((head + arc.head) / 2).real, y + 18), "offset(*h*) = (1, 0)", color="blue")
    canvas.dot(view.at(arc.tail), radius=DOT)
    canvas.dot(view.at(head), radius=DOT)
    canvas.circle(view.at(arc.head), DOT, fill="card", stroke="ink", width=2)
    canvas.text(view.at(arc.tail) - 12 + 1j, "tail(*h*)", size=NOTE, anchor="end")
    canvas.text(view.at(head) + 12 + 2j, "head(*h*)", size=NOTE, anchor="start")


def write_legend(canvas):
    entries = (("arrow", "orange", ["half-edge *h*, with the", "bubble on its left"]),
               ("arrow", "green", ["next(*h*): the next one,", "counter-clockwise"]),
               ("arrow", "pink", ["twin(*h*): the other side", "of the same film"]),
               ("dot", "ink", ["junction: stored once,", "in the torus’ own cell"]),
               ("ring", "ink", ["copy of a junction, at", "which the film ends"]),
               ("cell", "blue", ["the torus’ own cell;", "paler: its copies"]))
    y = MARGIN + 34
    for kind, color, lines in entries:
        draw_key(canvas, kind, color, complex(LEGEND, y))
        canvas.lines(complex(LEGEND + 44, y - 9), lines, anchor="start")
        y += 62


def draw_key(canvas, kind, color, left):
    """Draws the symbol of an entry of the legend."""
    if kind == "arrow":
        canvas.arrow(left, left + 30, color, width=THIN + 0.5)
    elif kind == "cell":
        canvas.rect(left + 4 - 11j, 22, 22, fill="neutral", stroke=color, width=THIN, dash=DASH)
    elif kind == "dot":
        canvas.dot(left + 15, radius=DOT)
    else:
        canvas.circle(left + 15, DOT, fill="card", stroke=color, width=2)


def half_edges(states):
    state = read_state(states / "torus", 1)
    half_edge = crossing_half_edge(state)
    view = View(CELL / state.periods.real, MARGIN * (1 + 1j) + PANEL / 2,
                state.periods / 2 + SHIFT * state.periods.real)
    canvas = Canvas(HEIGHT, "Half-edges and lattice offsets on a torus",
                    "The cell of a torus with a foam, and its copies around it. The film of the half-edge h starts at the "
                    "junction tail(h) and crosses the right border of the cell. It ends at the copy of the junction head(h) "
                    "one period to the right: the lattice offset of h is (1, 0). Next(h) follows h counter-clockwise around "
                    "the bubble on the left of h; twin(h) is the other side of the film.")
    draw_torus(canvas, state, view, half_edge)
    draw_offset(canvas, state, view, half_edge)
    draw_half_edges(canvas, state, view, half_edge)
    write_legend(canvas)
    return canvas
