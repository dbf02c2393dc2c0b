# SPDX-License-Identifier: Apache-2.0
"""Computes a drawing of a graph without cycles in layers, after Sugiyama, Tagawa and Toda (1981).

Every arrow of the graph points from a layer to a higher layer. An arrow that spans several layers has a bend, which is
a point without size, in each layer between.
"""
from dataclasses import dataclass, field

SWEEPS = 24  # sweeps that order the rows
PLACINGS = 400  # sweeps that compute the positions
STRAIGHT = 4  # weight of an arrow that should be straight; other arrows have the weight 1


@dataclass
class Layers:
    """The layers from the top to the bottom. A node is a name, or a tuple (from, to, layer), which is a bend."""
    rows: list
    above: dict = field(default_factory=dict)  # the neighbors of each node in the layer above
    below: dict = field(default_factory=dict)
    chains: dict = field(default_factory=dict)  # the nodes of each arrow (from, to), bends included


def is_bend(node):
    return isinstance(node, tuple)


def depths(uses):
    """Returns the layer of each node: one below the lowest of the nodes that it uses."""
    result = {}

    def depth(node):
        if node not in result:
            result[node] = 1 + max(map(depth, uses[node]), default=-1)
        return result[node]

    for node in uses:
        depth(node)
    return result


def make_layers(uses):
    """Returns the layers of a graph, in the order of its nodes, with bends."""
    depth = depths(uses)
    layers = Layers([[] for _ in range(1 + max(depth.values()))])
    for node in uses:
        layers.rows[depth[node]].append(node)
    for node, used in ((node, used) for node in uses for used in uses[node]):
        bends = [(node, used, row) for row in range(depth[node] - 1, depth[used], -1)]
        for bend in bends:
            layers.rows[bend[2]].append(bend)
        chain = [node, *bends, used]
        layers.chains[node, used] = chain
        for lower, upper in zip(chain, chain[1:]):
            layers.above.setdefault(lower, []).append(upper)
            layers.below.setdefault(upper, []).append(lower)
    return layers


def crossings(layers):
    """Returns the number of pairs of arrows that cross."""
    total = 0
    for upper, lower in zip(layers.rows, layers.rows[1:]):
        position = {node: index for index, node in enumerate(upper)}
        ends = [position[neighbor] for node in lower
                for neighbor in sorted(layers.above.get(node, []), key=position.get)]
        total += sum(a > b for index, a in enumerate(ends) for b in ends[index + 1:])
    return total


def order_by_neighbors(row, neighbors, fixed):
    """Sorts a row by the mean positions of the neighbors in the fixed row."""
    position = {node: index for index, node in enumerate(fixed)}
    own = {node: index for index, node in enumerate(row)}

    def mean(node):
        near = [position[neighbor] for neighbor in neighbors.get(node, [])]
        return sum(near) / len(near) if near else own[node]

    row.sort(key=mean)


def swap_where_better(layers):
    """Swaps adjacent nodes of a row if this removes crossings. Returns the number of crossings that remain."""
    best = crossings(layers)
    for row in layers.rows:
        for index in range(len(row) - 1):
            row[index], row[index + 1] = row[index + 1], row[index]
            count = crossings(layers)
            if count < best:
                best = count
            else:
                row[index], row[index + 1] = row[index + 1], row[index]
    return best


def reduce_crossings(layers):
    """Orders the rows such that few arrows cross."""
    best, best_rows = crossings(layers), [list(row) for row in layers.rows]
    last = len(layers.rows) - 1
    for _ in range(SWEEPS):
        for index in range(last):
            order_by_neighbors(layers.rows[index + 1], layers.above, layers.rows[index])
        for index in range(last, 0, -1):
            order_by_neighbors(layers.rows[index - 1], layers.below, layers.rows[index])
        count = swap_where_better(layers)
        if count < best:
            best, best_rows = count, [list(row) for row in layers.rows]
    layers.rows = best_rows


def spread(wishes, weights, gaps):
    """Returns positions whose distances are at least `gaps`. They are nearest to `wishes` by weighted least squares
    (pool adjacent violators, Ayer et al. 1955)."""
    offsets = [sum(gaps[:index]) for index in range(len(wishes))]
    blocks = []  # each: mean, weight, number of nodes
    for wish, weight, offset in zip(wishes, weights, offsets):
        blocks.append((wish - offset, weight, 1))
        while len(blocks) > 1 and blocks[-2][0] > blocks[-1][0]:
            (a, weight_a, count_a), (b, weight_b, count_b) = blocks[-2:]
            total = weight_a + weight_b
            blocks[-2:] = [((a * weight_a + b * weight_b) / total, total, count_a + count_b)]
    means = [mean for mean, _, count in blocks for _ in range(count)]
    return [mean + offset for mean, offset in zip(means, offsets)]


def place(layers, gap_of):
    """Returns the x of every node, near its neighbors. Adjacent nodes a, b of a row are at least gap_of(a, b) apart."""
    x = {node: 100.0 * index for row in layers.rows for index, node in enumerate(row)}
    for sweep in range(PLACINGS):
        rows = layers.rows if sweep % 2 == 0 else layers.rows[::-1]
        for row in rows:
            place_row(layers, row, x, gap_of)
    for row in layers.rows:
        straighten(layers, row, x, gap_of)
    return x


def straighten(layers, row, x, gap_of):
    """Moves each node of a row below the node to which a straight arrow points, as far as adjacent nodes allow."""
    for index, node in enumerate(row):
        wishes = [x[other] for other in layers.above.get(node, []) if is_straight(layers, node, other)]
        for wish in wishes:
            left = x[row[index - 1]] + gap_of(row[index - 1], node) if index > 0 else wish
            right = x[row[index + 1]] - gap_of(node, row[index + 1]) if index + 1 < len(row) else wish
            x[node] = max(left, min(right, wish))


def is_straight(layers, node, other):
    """Returns true if an arrow should be straight: it connects two bends, or neither of its nodes has another arrow
    between the same layers."""
    if is_bend(node) and is_bend(other):
        return True
    lower, upper = (node, other) if other in layers.above.get(node, []) else (other, node)
    return len(layers.above[lower]) == 1 and len(layers.below[upper]) == 1


def place_row(layers, row, x, gap_of):
    wishes, weights = [], []
    for node in row:
        near = layers.above.get(node, []) + layers.below.get(node, [])
        strengths = [STRAIGHT if is_straight(layers, node, other) else 1 for other in near]
        wishes.append(sum(s * x[other] for s, other in zip(strengths, near)) / sum(strengths))
        weights.append(sum(strengths))
    gaps = [gap_of(a, b) for a, b in zip(row, row[1:])]
    x.update(zip(row, spread(wishes, weights, gaps)))
