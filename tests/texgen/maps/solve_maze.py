#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Solves the maze of a picture by a flood fill, without knowing the foam.

Usage: solve_maze.py MAZE IDS

MAZE is a binary PGM of 8 bits in which passages are light, walls are dark and the space around the maze has the value
of passages. IDS is a PGM of 16 bits of the same size whose pixels are the number of a bubble plus 1, and 0 around the
foam. The script looks for two gaps in the outer wall, fills the passages from one gap, and prints the numbers of the
bubbles on the shortest way to the other gap, in order. It exits with 1 if there are not exactly two gaps, if no
way leads from one to the other, or if the dark pixels are not exactly two walls, as in every maze with a single way.
"""
import collections
import sys


def read_pgm(path):
    data = open(path, "rb").read()
    fields, at = [], 0
    while len(fields) < 4:
        end = min(i for i in (data.find(b" ", at), data.find(b"\n", at)) if i >= 0)
        fields.append(data[at:end])
        at = end + 1
    width, height, largest = (int(field) for field in fields[1:])
    if largest < 256:
        values = list(data[at:at + width * height])
    else:
        values = [256 * data[at + 2 * k] + data[at + 2 * k + 1] for k in range(width * height)]
    return width, height, values


def neighbors(k, width, height, diagonal=False):
    x, y = k % width, k // width
    for dx in (-1, 0, 1):
        for dy in (-1, 0, 1):
            if (dx or dy) and (diagonal or not (dx and dy)) and 0 <= x + dx < width and 0 <= y + dy < height:
                yield k + dx + dy * width


def components(members, width, height):
    """Returns the connected groups of a set of pixels, diagonal neighbors included."""
    rest, groups = set(members), []
    while rest:
        group, front = set(), [rest.pop()]
        while front:
            k = front.pop()
            group.add(k)
            for n in neighbors(k, width, height, diagonal=True):
                if n in rest:
                    rest.remove(n)
                    front.append(n)
        groups.append(group)
    return groups


def main():
    width, height, tones = read_pgm(sys.argv[1])
    _, _, ids = read_pgm(sys.argv[2])
    dark = {k for k, tone in enumerate(tones) if tone < 128}
    walls = [group for group in components(dark, width, height) if len(group) > 20]
    # A gap is where a light pixel of a bubble touches a light pixel of the surroundings.
    rim = {k for k in range(width * height) if ids[k] and k not in dark
           and any(ids[n] == 0 and n not in dark for n in neighbors(k, width, height))}
    gaps = [group for group in components(rim, width, height) if len(group) > 3]
    if len(gaps) != 2 or len(walls) != 2:
        sys.exit(1)
    came_from = {k: None for k in gaps[0]}
    queue = collections.deque(gaps[0])
    while queue:
        k = queue.popleft()
        if k in gaps[1]:
            break
        for n in neighbors(k, width, height):
            if n not in came_from and ids[n] and n not in dark:
                came_from[n] = k
                queue.append(n)
    if k not in gaps[1]:
        sys.exit(1)
    way = []
    while k is not None:
        bubble = ids[k] - 1
        if bubble in way:  # the way went to and fro across a curved film
            del way[way.index(bubble) + 1:]
        else:
            way.append(bubble)
        k = came_from[k]
    print("\n".join(str(bubble) for bubble in reversed(way)))


main()
