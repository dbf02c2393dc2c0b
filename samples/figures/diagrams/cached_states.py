# SPDX-License-Identifier: Apache-2.0
"""Reads the states of a cache that `foamtex simulate` wrote (texgen/cache/README.md)."""
import math
import struct
import zlib
from dataclasses import dataclass

from arcs import Arc

HEADER = struct.Struct("<8s8sII32sQQ")
VERSION = 1  # version of packed files
RAW_DEFLATE = -15  # window bits of a deflate stream without a header
LARGEST_SINE = math.sin(math.radians(80))  # half angles of inner films are clamped (E3)


class Reader:
    """Reads numbers from bytes. The lowest byte of a number is first."""

    def __init__(self, content):
        self.content = content
        self.position = 0

    def take(self, kinds):
        """Returns the next numbers. `kinds` are their format characters in the module struct."""
        values = struct.unpack_from("<" + kinds, self.content, self.position)
        self.position += struct.calcsize("<" + kinds)
        return values

    def take_one(self, kind):
        return self.take(kind)[0]

    def take_many(self, kind, count):
        return list(self.take(f"{count}{kind}"))


@dataclass
class State:
    """One frame of a foam. The half-edges of film k are 2k, from its tail to its head, and 2k + 1."""
    number: int
    periods: complex  # width and height of the torus; 0 for a patch
    shear: float
    tension: float
    tails: dict  # the junction that a half-edge leaves
    next: dict  # the next half-edge around the bubble on the left
    offsets: list  # the lattice offsets (i, j) of the half-edges 2k
    first: list  # one half-edge per bubble
    left: dict  # the bubble on the left of a half-edge, without the half-edges of the ghost
    identities: list
    target_areas: list
    pressures: list
    positions: list
    half_angles: dict  # the half angle of the half-edge 2k of each outer film k

    def offset(self, half_edge):
        i, j = self.offsets[half_edge // 2]
        return (i, j) if half_edge % 2 == 0 else (-i, -j)

    def translation(self, offset):
        i, j = offset
        return complex(i * self.periods.real + j * self.shear, j * self.periods.imag)

    def is_outer(self, half_edge):
        return half_edge not in self.left or twin(half_edge) not in self.left

    def half_angle(self, half_edge, chord):
        """Returns the half angle of a half-edge: stored for an outer film, computed by E1 for an inner film."""
        if self.is_outer(half_edge):
            stored = self.half_angles[half_edge // 2]
            return stored if half_edge % 2 == 0 else -stored
        difference = self.pressures[self.left[half_edge]] - self.pressures[self.left[twin(half_edge)]]
        sine = difference * abs(chord) / (2 * self.tension)
        return math.asin(max(-LARGEST_SINE, min(LARGEST_SINE, sine)))

    def arc(self, half_edge):
        """Returns the arc of a half-edge, with its tail in the cell of the torus."""
        tail = self.positions[self.tails[half_edge]]
        head = self.positions[self.tails[twin(half_edge)]] + self.translation(self.offset(half_edge))
        return Arc(tail, head, self.half_angle(half_edge, head - tail))

    def around(self, half_edge):
        """Returns the half-edges around the bubble, the hole or the patch on the left, starting with this one."""
        loop = [half_edge]
        while self.next[loop[-1]] != half_edge:
            loop.append(self.next[loop[-1]])
        return loop

    def outline(self, half_edge):
        """Returns the arcs of the half-edges that `around` returns, each moved to the end of the preceding arc."""
        arcs, end = [], self.arc(half_edge).tail
        for side in self.around(half_edge):
            arc = self.arc(side)
            arcs.append(arc.moved(end - arc.tail))
            end = arcs[-1].head
        return arcs

    def bubble(self, identity):
        """Returns the index of the bubble with an identity."""
        if identity not in self.identities:
            raise ValueError(f"frame {self.number}: there is no bubble {identity}")
        return self.identities.index(identity)

    def ghost_sides(self):
        """Returns the half-edges of the ghost."""
        return [half_edge for half_edge in sorted(self.next) if half_edge not in self.left]


def twin(half_edge):
    return half_edge ^ 1


def content_of(path):
    """Returns the decompressed content of a packed file."""
    packed = path.read_bytes()
    magic, kind, version, *_ = HEADER.unpack_from(packed)
    if (magic.rstrip(b"\0"), kind.rstrip(b"\0"), version) != (b"foamtex", b"state", VERSION):
        raise ValueError(f"{path}: expected a state of foamtex of version {VERSION}")
    return zlib.decompress(packed[HEADER.size:], RAW_DEFLATE)


def read_topology(reader):
    """Returns tails and successors of half-edges, lattice offsets of films, and one half-edge per bubble."""
    junctions = reader.take_one("I")
    tails, successors = {}, {}
    for junction in range(junctions):
        leaving = reader.take("3I")
        for index, half_edge in enumerate(leaving):
            tails[half_edge] = junction
            successors[twin(half_edge)] = leaving[(index + 1) % 3]
    offsets = [reader.take("2i") for _ in range(3 * junctions // 2)]
    first = reader.take_many("I", reader.take_one("I"))
    if reader.take_one("B"):
        reader.take_one("I")  # skips one of the half-edges of the ghost
    return tails, successors, offsets, first


def bubbles_on_left(first, successors):
    left = {}
    for bubble, half_edge in enumerate(first):
        while half_edge not in left:
            left[half_edge] = bubble
            half_edge = successors[half_edge]
    return left


def read_state(cache, number):
    """Returns the state with a number from a cache."""
    reader = Reader(content_of(cache / f"state.{number:06}.foam"))
    frame, _, width, height, shear, tension = reader.take("i5d")
    tails, successors, offsets, first = read_topology(reader)
    left = bubbles_on_left(first, successors)
    bubbles = len(first)
    identities = reader.take_many("I", bubbles)
    target_areas = reader.take_many("d", bubbles)
    pressures = reader.take_many("d", bubbles)
    positions = [complex(*reader.take("2d")) for _ in range(len(tails) // 3)]
    outer = [film for film in range(len(offsets)) if (2 * film in left) != (2 * film + 1 in left)]
    half_angles = {film: reader.take_one("d") for film in outer}
    return State(frame, complex(width, height), shear, tension, tails, successors, offsets, first, left, identities,
                 target_areas, pressures, positions, half_angles)
