// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// A node: consecutive rows of a symmetric matrix that belong together and share one position. For
/// a foam, the rows of a node are the two coordinates of a junction, the pressure of a bubble, or
/// the half angle of an outer film.
struct SolverNode {
    Vec2 position;
    int rows = 1;  // number of rows
};

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
