# SPDX-License-Identifier: Apache-2.0
"""Draws the two changes of topology, each in three frames of a simulation."""
import cmath
import math

from arcs import Arc, View
from cached_states import read_state, twin
from canvas import FILM, MARGIN, NOTE, THIN, WIDTH, Canvas
from window import film_between, films_near, outline_near, room_for_label

RADIUS = 118  # radius of a window, in pixels
PANELS = (MARGIN + RADIUS, WIDTH / 2, WIDTH - MARGIN - RADIUS)  # x of the windows
ROW = 322  # distance from the upper row of windows to the lower row
HEIGHT = 2 * ROW + 20

# The T1: the numbers of three states of the shear flow; bubbles A and B, whose film vanishes; bubbles C and D.
T1_STATES = (20, 74, 75)
T1_SCALE = 72
A, B, C, D = 17, 32, 21, 41
T1_NAMES = {A: "A", B: "B", C: "C", D: "D"}
T1_TINTS = {A: "blue-tint", B: "blue-tint", C: "orange-tint", D: "orange-tint"}
T1_CAPTIONS = ("A and B share a film", "the film becomes short", "C and D share a film")

# The T2: the numbers of three states of a foam that coarsens, and the bubble that vanishes.
T2_STATES = (1, 16, 22)
T2_SCALE = 66
VANISHING = 35
T2_CAPTIONS = ("a bubble of three sides", "the bubble shrinks", "one junction is left: 3 × 120°")


def neighbors(state, identity):
    """Returns the identities of the bubbles around a bubble."""
    sides = state.around(state.first[state.bubble(identity)])
    return [state.identities[state.left[twin(side)]] for side in sides]


def sides_of(state, identity):
    return len(state.around(state.first[state.bubble(identity)]))


def draw_window(canvas, name, state, view, tints):
    """Draws the foam in a round window."""
    radius = RADIUS / view.scale
    canvas.clip_circle(name, view.middle, RADIUS)
    canvas.circle(view.middle, RADIUS, fill="neutral")
    for identity, tint in tints.items():
        canvas.path(view.path(outline_near(state, identity, view.center), closed=True), fill=tint, clip=name)
    films = films_near(state, view.center, radius)
    canvas.path("".join(view.path([film]) for film in films), stroke="ink", width=FILM, clip=name)
    canvas.circle(view.middle, RADIUS, stroke="faint", width=THIN)


def label_bubbles(canvas, state, view, names, **style):
    for identity, name in names.items():
        outline = outline_near(state, identity, view.center)
        canvas.text(view.at(room_for_label(outline, view.center, RADIUS / view.scale)), name, **style)


def draw_captions(canvas, y, title, captions):
    """Writes the title of a row and the captions of its windows, and draws the arrows between them."""
    canvas.text(complex(MARGIN, y - RADIUS - 26), title, anchor="start", bold=True)
    for x, caption in zip(PANELS, captions):
        canvas.text(complex(x, y + RADIUS + 22), caption, size=NOTE)
    for left, right in zip(PANELS, PANELS[1:]):
        middle = (left + right) / 2
        canvas.arrow(complex(middle - 14, y), complex(middle + 14, y), "muted", width=FILM)


def draw_t1(canvas, cache, y):
    states = [read_state(cache, number) for number in T1_STATES]
    for index, (x, state) in enumerate(zip(PANELS, states)):
        pair, color = ((A, B), "blue") if index < 2 else ((C, D), "orange")
        film = film_between(state, *pair, state.periods / 2)
        view = View(T1_SCALE, complex(x, y), film.point_at(0.5))
        draw_window(canvas, f"t1-{index}", state, view, T1_TINTS)
        canvas.path(view.path([film]), stroke=color, width=2 * FILM)
        label_bubbles(canvas, state, view, T1_NAMES)
    draw_captions(canvas, y, "T1: two bubbles part, two others touch", T1_CAPTIONS)


def draw_t2(canvas, cache, y):
    states = [read_state(cache, number) for number in T2_STATES]
    around = neighbors(states[1], VANISHING)
    junctions = [arc.tail for arc in outline_near(states[1], VANISHING, states[1].periods / 2)]
    center = sum(junctions) / len(junctions)
    for index, (x, state) in enumerate(zip(PANELS, states)):
        view = View(T2_SCALE, complex(x, y), center)
        tints = dict.fromkeys(around, "green-tint")
        if VANISHING in state.identities:
            tints[VANISHING] = "pink-tint"
        draw_window(canvas, f"t2-{index}", state, view, tints)
        names = {identity: f"{sides_of(state, identity)} sides" for identity in around}
        label_bubbles(canvas, state, view, names, size=NOTE)
    draw_captions(canvas, y, "T2: a bubble vanishes, and each of its three neighbors loses a side", T2_CAPTIONS)
    draw_angles(canvas, states[-1], View(T2_SCALE, complex(PANELS[-1], y), center))


def draw_angles(canvas, state, view):
    """Marks the three angles of 120 degrees at the junction that replaces the bubble."""
    films = films_near(state, view.center, 1)
    junction = min((end for film in films for end in (film.tail, film.head)), key=lambda end: abs(end - view.center))
    film = next(film for film in films if abs(film.tail - junction) < 1e-9)
    begin = 0.3 * film.direction_at(0)
    for _ in range(3):
        end = begin * cmath.exp(2j / 3 * math.pi)
        canvas.path(view.path([Arc(junction + begin, junction + end, math.pi / 3)]), stroke="muted", width=THIN)
        begin = end


def t1_and_t2(states):
    canvas = Canvas(HEIGHT, "T1 and T2",
                    "Above, a T1 in three frames: bubbles A and B share a film, which becomes short; then bubbles C and D "
                    "share a film instead. Below, a T2 in three frames: a bubble of three sides shrinks and becomes one "
                    "junction; each of its three neighbors loses a side.")
    draw_t1(canvas, states / "shear", 62 + RADIUS)
    draw_t2(canvas, states / "coarsening", ROW + 62 + RADIUS)
    return canvas
