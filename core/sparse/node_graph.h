// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// Consecutive rows of a symmetric matrix that belong together and have one position. For a foam
/// these are the two coordinates of a junction, the pressure of a bubble, or the half angle of an
/// outer film.
struct SolverNode {
    Vec2 position;
    int rows = 1;
};

/// The graph of coupled nodes: undirected, without loops, as adjacency lists.
struct NodeGraph {
    std::vector<std::uint32_t> neighbors;  // neighbors of all nodes, sorted by node
    std::vector<std::size_t> begins;  // start of each node's neighbors, and the end of the last

    std::span<const std::uint32_t> of(std::size_t node) const {
        return std::span(neighbors).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// Returns the graph in which two nodes are coupled if they share an entry of the matrix. `lower`
/// is the lower triangle of the matrix. The first node has the first rows, the second node the next
/// ones, and so on.
NodeGraph coupling(const Eigen::SparseMatrix<double>& lower, std::span<const SolverNode> nodes);

}  // namespace foam
