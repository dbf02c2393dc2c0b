// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/domain.h"
#include "core/sparse/front_planner.h"
#include "core/sparse/weighted_graph.h"
#include "core/sparse/zone.h"

#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <utility>
#include <vector>

namespace foam::test {

/// A symmetric matrix whose rows belong to points, one row per point.
struct PointSystem {
    Domain domain;
    std::vector<SolverNode> nodes;
    Eigen::SparseMatrix<double> matrix;  // lower triangle
};

/// Returns the lower triangle of a matrix. The entry of each pair of coupled rows is -1; the lower
/// row is the first of the pair. The diagonal is 10, 11, 12, ..., so that all pivots are positive
/// if no row is coupled to more than nine others.
inline Eigen::SparseMatrix<double> coupled_matrix(
    Eigen::Index rows, const std::vector<std::pair<Eigen::Index, Eigen::Index>>& pairs) {
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index row = 0; row < rows; ++row) {
        entries.emplace_back(row, row, 10.0 + static_cast<double>(row));
    }
    for (const auto& [low, high] : pairs) {
        entries.emplace_back(high, low, -1.0);
    }
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

/// Returns the points of a square grid on the torus, row after row. Each is coupled to the four
/// adjacent points. Precondition: width and height are at least 3.
inline PointSystem torus_grid(int width, int height) {
    PointSystem grid{{static_cast<double>(width), static_cast<double>(height)}, {}, {}};
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    const auto index = [=](int x, int y) { return Eigen::Index{y % height * width + x % width}; };
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            grid.nodes.push_back({Vec2(x + 0.5, y + 0.5), 1});
            pairs.push_back(std::minmax({index(x, y), index(x + 1, y)}));
            pairs.push_back(std::minmax({index(x, y), index(x, y + 1)}));
        }
    }
    grid.matrix = coupled_matrix(index(width - 1, height - 1) + 1, pairs);
    return grid;
}

/// Returns points on a line in the plane, each coupled to all others.
inline PointSystem complete_system(int points) {
    PointSystem system{kPlane, {}, {}};
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    for (int point = 0; point < points; ++point) {
        system.nodes.push_back({Vec2(point, 0.0), 1});
        for (int earlier = 0; earlier < point; ++earlier) {
            pairs.emplace_back(earlier, point);
        }
    }
    system.matrix = coupled_matrix(points, pairs);
    return system;
}

/// Returns the points of a square grid in the plane, row after row. Each is coupled to the adjacent
/// points.
inline PointSystem plane_grid(int side) {
    PointSystem grid{kPlane, {}, {}};
    std::vector<std::pair<Eigen::Index, Eigen::Index>> pairs;
    for (Eigen::Index y = 0; y < side; ++y) {
        for (Eigen::Index x = 0; x < side; ++x) {
            grid.nodes.push_back({Vec2(static_cast<double>(x), static_cast<double>(y)), 1});
            if (x + 1 < side) {
                pairs.emplace_back(y * side + x, y * side + x + 1);
            }
            if (y + 1 < side) {
                pairs.emplace_back(y * side + x, (y + 1) * side + x);
            }
        }
    }
    grid.matrix = coupled_matrix(Eigen::Index{side} * side, pairs);
    return grid;
}

/// Returns the graph of the coupled points. All its edges have weight 1.
inline WeightedGraph graph_of(const PointSystem& system) {
    const NodeGraph coupled = node_graph(system.matrix, system.nodes);
    WeightedGraph graph;
    for (const SolverNode& node : system.nodes) {
        graph.weights.push_back(node.rows);
    }
    for (const std::uint32_t neighbor : coupled.neighbors) {
        graph.edges.push_back({neighbor, 1});
    }
    for (const std::size_t begin : coupled.begins) {
        graph.begins.push_back(static_cast<std::uint32_t>(begin));
    }
    return graph;
}

/// Gives the points random positions, which say nothing about their couplings.
inline void scatter(PointSystem& system) {
    std::mt19937 bits(1);
    const auto fraction = [&bits] { return static_cast<double>(bits()) / 4294967296.0; };
    for (SolverNode& node : system.nodes) {
        const double x = fraction() * system.domain.width;
        const double y = fraction() * system.domain.height;
        node.position = Vec2(x, y);
    }
}

/// Returns the number of edges between the zones Low and High.
inline int edges_across(const WeightedGraph& graph, std::span<const Zone> zones) {
    int across = 0;
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        for (const WeightedGraph::Edge& edge : graph.edges_of(node)) {
            across += zones[node] == Zone::Low && zones[edge.to] == Zone::High ? 1 : 0;
        }
    }
    return across;
}

/// Returns the total weight of the nodes in a zone.
inline int weight_of(const WeightedGraph& graph, std::span<const Zone> zones, Zone zone) {
    int weight = 0;
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
        weight += zones[node] == zone ? graph.weights[node] : 0;
    }
    return weight;
}

/// Returns the plan for a matrix in the order of a new dissection, or std::nullopt if the plan is
/// larger than `limit`.
inline std::optional<FrontPlan> plan_within(const Eigen::SparseMatrix<double>& matrix,
                                            std::span<const SolverNode> nodes,
                                            const Domain& domain,
                                            std::size_t limit) {
    const NodeGraph graph = node_graph(matrix, nodes);
    return plan_fronts(matrix, nodes, graph, dissect(graph, nodes, domain, {}), limit);
}

/// Returns the plan for a system, practically without a limit on its size.
inline FrontPlan plan_of(const PointSystem& system) {
    return *plan_within(system.matrix, system.nodes, system.domain, std::size_t{1} << 40U);
}

/// Returns both triangles of the matrix. Rows and columns are in the order of elimination.
inline Eigen::MatrixXd reordered(const PointSystem& system, const FrontPlan& plan) {
    const Eigen::SparseMatrix<double> whole = system.matrix.selfadjointView<Eigen::Lower>();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(whole.rows(), whole.cols());
    for (Eigen::Index column = 0; column < whole.cols(); ++column) {
        for (Eigen::SparseMatrix<double>::InnerIterator at(whole, column); at; ++at) {
            result(plan.position_of_row[static_cast<std::size_t>(at.row())],
                   plan.position_of_row[static_cast<std::size_t>(column)]) = at.value();
        }
    }
    return result;
}

/// Returns the rows of a front in the order of its slots.
inline std::vector<std::size_t> rows_of(const FrontPlan& plan, const Front& front) {
    std::vector<std::size_t> rows;
    for (std::size_t pivot = 0; pivot < front.pivots; ++pivot) {
        rows.push_back(front.first_row + pivot);
    }
    const std::span<const std::uint32_t> border = plan.rows_of_border(front);
    rows.insert(rows.end(), border.begin(), border.end());
    return rows;
}

}  // namespace foam::test
