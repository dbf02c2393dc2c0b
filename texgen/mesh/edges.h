// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <span>
#include <vector>

namespace foam::texgen {

/// A triangle as three indices of points.
using Triangle = std::array<std::uint32_t, 3>;

/// A directed side of a triangle. The upper 32 bits are the index of the point where the side
/// begins, the lower 32 bits the index of the point where it ends.
using Edge = std::uint64_t;

constexpr Edge edge_between(std::uint32_t from, std::uint32_t to) {
    return Edge{from} << 32 | to;
}
constexpr std::uint32_t start_of(Edge edge) {
    return static_cast<std::uint32_t>(edge >> 32);
}
constexpr std::uint32_t end_of(Edge edge) {
    return static_cast<std::uint32_t>(edge);
}
constexpr Edge opposite(Edge edge) {
    return edge << 32 | edge >> 32;
}

/// Returns the three edges of every triangle, in ascending order.
inline std::vector<Edge> sorted_edges(std::span<const Triangle> triangles) {
    std::vector<Edge> edges;
    edges.reserve(3 * triangles.size());
    for (const auto& [a, b, c] : triangles) {
        edges.insert(edges.end(), {edge_between(a, b), edge_between(b, c), edge_between(c, a)});
    }
    std::ranges::sort(edges);
    return edges;
}

/// Returns true if no edge occurs twice. Precondition: the edges are in ascending order.
inline bool are_distinct(std::span<const Edge> edges) {
    return std::ranges::adjacent_find(edges) == edges.end();
}

/// Returns the edges whose opposite edge does not occur: the border of the triangles.
/// Precondition: the edges are in ascending order.
inline std::vector<Edge> unpaired(std::span<const Edge> edges) {
    std::vector<Edge> border;
    std::ranges::copy_if(edges, std::back_inserter(border), [&](Edge edge) {
        return !std::ranges::binary_search(edges, opposite(edge));
    });
    return border;
}

}  // namespace foam::texgen
