#pragma once

#include "core/geometry/vec2.h"

#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam {

/// Successive rows of a symmetric matrix that stand for one thing at a point of the torus: the two
/// coordinates of a junction, the pressure of a bubble, or the half angle of an outer film.
struct SolverNode {
    Vec2 position;
    int rows = 1;
};

/// Which nodes are coupled: a symmetric relation without loops.
struct NodeGraph {
    std::vector<std::uint32_t> neighbours;  // of all nodes, node after node
    std::vector<std::size_t> begins;        // of each node's among them, and the end

    std::span<const std::uint32_t> of(std::size_t node) const {
        return std::span(neighbours).subspan(begins[node], begins[node + 1] - begins[node]);
    }
};

/// The nodes that share an entry of the matrix, whose lower triangle is given. The nodes take up
/// the rows in turn.
NodeGraph coupling(const Eigen::SparseMatrix<double>& lower, std::span<const SolverNode> nodes);

}  // namespace foam
