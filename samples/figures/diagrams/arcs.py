# SPDX-License-Identifier: Apache-2.0
"""Circular arcs, which are the shapes of films (E1 of core/EQUATIONS.md), and the view in which they are drawn.

Points of the foam are complex numbers in foam units: x points right, y points up.
"""
import cmath
import math
from dataclasses import dataclass

from canvas import pair


@dataclass
class Arc:
    """An arc from tail to head. `half_angle` is half the angle by which its tangent turns left, in radians."""
    tail: complex
    head: complex
    half_angle: float = 0.0

    @property
    def chord(self):
        return self.head - self.tail

    @property
    def radius(self):
        return math.inf if self.is_straight else abs(self.chord) / (2 * math.sin(abs(self.half_angle)))

    @property
    def is_straight(self):
        return abs(self.half_angle) < 1e-6

    @property
    def length(self):
        return abs(self.chord) * (1 if self.is_straight else self.half_angle / math.sin(self.half_angle))

    def direction_at(self, fraction):
        """Returns the unit tangent at a fraction of the length."""
        return self.chord / abs(self.chord) * cmath.exp(1j * (2 * fraction - 1) * self.half_angle)

    def point_at(self, fraction):
        """Returns the point at a fraction of the length."""
        if self.is_straight:
            return self.tail + fraction * self.chord
        turned = cmath.exp(1j * (fraction - 1) * self.half_angle)
        return self.tail + self.chord * turned * math.sin(fraction * self.half_angle) / math.sin(self.half_angle)

    def reversed(self):
        return Arc(self.head, self.tail, -self.half_angle)

    def moved(self, by):
        return Arc(self.tail + by, self.head + by, self.half_angle)

    def part(self, first, last):
        """Returns the piece between two fractions of the length."""
        return Arc(self.point_at(first), self.point_at(last), (last - first) * self.half_angle)

    def beside(self, distance):
        """Returns the concentric arc at a distance on the left."""
        return Arc(self.tail + 1j * distance * self.direction_at(0),
                   self.head + 1j * distance * self.direction_at(1), self.half_angle)


@dataclass
class View:
    """Maps points of the foam to pixels: the point `center` is drawn at `middle`, and a foam unit is `scale` pixels."""
    scale: float
    middle: complex
    center: complex = 0j

    def at(self, point):
        return self.middle + self.scale * (point - self.center).conjugate()

    def arc_to(self, arc):
        """Returns the path data that continues a path from the tail of the arc along it."""
        if arc.is_straight:
            return "L" + pair(self.at(arc.head))
        radius = self.scale * arc.radius
        large = int(abs(arc.half_angle) > math.pi / 2)
        clockwise = int(arc.half_angle < 0)
        return f"A{pair(complex(radius, radius))} 0 {large} {clockwise} {pair(self.at(arc.head))}"

    def path(self, arcs, closed=False):
        """Returns the path data of arcs, each of which starts at the end of the preceding arc."""
        return "M" + pair(self.at(arcs[0].tail)) + "".join(map(self.arc_to, arcs)) + ("Z" if closed else "")
