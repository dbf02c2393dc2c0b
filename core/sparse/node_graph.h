// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace foam {

/// A node: consecutive rows of a symmetric matrix that belong together and share one position. In
/// the matrix of a foam, a node represents a junction (two coordinates), a bubble (its pressure) or
/// an outer film (its half angle).
struct SolverNode {
    Vec2 position;
    int rows = 1;  // number of rows
    // If two matrices have nodes with the same name, these nodes represent the same unknowns. Names
    // are only used to keep the order of elimination (LdltOptions::keeps_order).
    std::uint64_t name = 0;
};

/// The number of a node that has not been numbered.
inline constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

/// The graph of coupled nodes as adjacency lists. It is undirected and has no edges from a node to
/// itself.
struct NodeGraph {
    std::vector<std::uint32_t> neighbors;  // neighbors of node 0, then of node 1, ...
    // For each node, the index of its first neighbor in `neighbors`; finally the size of
    // `neighbors`.
    std::vector<std::size_t> begins;

    /// Returns the neighbors of a node.
    std::span<const std::uint32_t> neighbors_of(std::size_t node) const {
        return std::span(neighbors).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// Returns the graph whose edges connect coupled nodes. Two nodes are coupled if the matrix has an
/// entry in a row of one node and a column of the other. `lower` is the lower triangle of the
/// matrix. The first node has the first rows of the matrix, the second node has the next rows, and
/// so on.
NodeGraph node_graph(const Eigen::SparseMatrix<double>& lower, std::span<const SolverNode> nodes);

}  // namespace foam
