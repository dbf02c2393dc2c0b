// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/dissection.h"

#include "core/equilibrium/hessian.h"
#include "core/equilibrium/linear_solver.h"
#include "core/foam/honeycomb.h"
#include "core/foam/seeding.h"
#include "tests/support/sample_foams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <vector>

namespace foam {
namespace {

struct CoupledNodes {
    Domain domain;
    std::vector<SolverNode> nodes;
    NodeGraph graph;
};

CoupledNodes coupled_nodes(const Foam& foam) {
    const Unknowns unknowns = all_unknowns(foam.network);
    const std::vector<SolverNode> nodes = solver_nodes(foam, unknowns);
    return {foam.domain, nodes, node_graph(Hessian(foam.network, unknowns).matrix(), nodes)};
}

CoupledNodes random_nodes(int bubbles, double aspect, std::uint64_t seed = 1) {
    SeedingOptions options;
    options.bubbles = bubbles;
    options.aspect = aspect;
    options.seed = seed;
    return coupled_nodes(seed_foam(options));
}

// Returns nodes on a line, each with one row of the matrix and the given neighbors.
CoupledNodes nodes_in_row(const std::vector<std::vector<std::uint32_t>>& neighbors) {
    CoupledNodes row{{static_cast<double>(neighbors.size()), 1.0}, {}, {}};
    row.graph.begins.push_back(0);
    for (std::size_t node = 0; node < neighbors.size(); ++node) {
        row.nodes.push_back({Vec2(static_cast<double>(node), 0.5), 1});
        row.graph.neighbors.insert(
            row.graph.neighbors.end(), neighbors[node].begin(), neighbors[node].end());
        row.graph.begins.push_back(row.graph.neighbors.size());
    }
    return row;
}

Dissection dissect(const CoupledNodes& coupled, const DissectionOptions& options = {}) {
    return dissect(coupled.graph, coupled.nodes, coupled.domain, options);
}

// Returns the index in the order of elimination at which the subtree of a part begins.
std::size_t subtree_begin(const Dissection& dissection, std::size_t part) {
    while (!dissection.parts[part].is_leaf()) {
        part = dissection.parts[part].left;
    }
    return dissection.parts[part].begin;
}

bool covers_every_node_once(const Dissection& dissection) {
    std::vector<std::uint32_t> nodes = dissection.order;
    std::sort(nodes.begin(), nodes.end());
    std::size_t end = 0;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        if (nodes[node] != node) {
            return false;
        }
    }
    for (const DissectionPart& part : dissection.parts) {
        if (part.begin != end || part.end < part.begin) {
            return false;
        }
        end = part.end;
    }
    return end == nodes.size();
}

// Returns the number of coupled pairs of nodes of which one is in the left and one in the right
// subtree of a part.
int couplings_across(const CoupledNodes& coupled, const Dissection& dissection) {
    std::vector<std::size_t> turns(dissection.order.size());
    for (std::size_t turn = 0; turn < turns.size(); ++turn) {
        turns[dissection.order[turn]] = turn;
    }
    int across = 0;
    for (const DissectionPart& part : dissection.parts) {
        if (part.is_leaf()) {
            continue;
        }
        const std::size_t left_begin = subtree_begin(dissection, part.left);
        const std::size_t right_begin = subtree_begin(dissection, part.right);
        for (std::size_t turn = left_begin; turn < right_begin; ++turn) {
            for (const std::uint32_t neighbor :
                 coupled.graph.neighbors_of(dissection.order[turn])) {
                across += turns[neighbor] >= right_begin && turns[neighbor] < part.begin ? 1 : 0;
            }
        }
    }
    return across;
}

int rows_of(const CoupledNodes& coupled, const Dissection& dissection, const DissectionPart& part) {
    int rows = 0;
    for (std::size_t turn = part.begin; turn < part.end; ++turn) {
        rows += coupled.nodes[dissection.order[turn]].rows;
    }
    return rows;
}

void expect_sound(const CoupledNodes& coupled) {
    const Dissection dissection = dissect(coupled);
    EXPECT_EQ(dissection.order.size(), coupled.nodes.size());
    EXPECT_TRUE(covers_every_node_once(dissection));
    EXPECT_EQ(couplings_across(coupled, dissection), 0);
}

TEST(Dissect, EliminatesTheHighestNodesOfEachPartFirst) {
    const Dissection dissection = dissect(random_nodes(300, 1.0));
    for (const DissectionPart& part : dissection.parts) {
        const auto begin = dissection.order.begin();
        EXPECT_TRUE(std::is_sorted(begin + static_cast<std::ptrdiff_t>(part.begin),
                                   begin + static_cast<std::ptrdiff_t>(part.end),
                                   std::greater<>()));
    }
}

TEST(Dissection, PartsFoamsOfEverySize) {
    for (const int bubbles : {2, 3, 5, 10, 40, 150, 500}) {
        for (const double aspect : {1.0, 4.0, 0.1}) {
            SCOPED_TRACE(testing::Message() << bubbles << " bubbles, aspect " << aspect);
            expect_sound(random_nodes(bubbles, aspect));
        }
    }
}

// In parts of about a hundred rows, few nodes are so far from the separator that refinement treats
// them together as one node.
TEST(Dissection, SeparatorsOfManySmallPartsSeparate) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        for (const int bubbles : {30, 60, 120, 240, 480}) {
            const CoupledNodes coupled = random_nodes(bubbles, 1.0, seed);
            EXPECT_EQ(couplings_across(coupled, dissect(coupled)), 0)
                << bubbles << " bubbles, seed " << seed;
        }
    }
}

TEST(Dissection, PartsFoamsWhoseBubblesMeetThemselves) {
    expect_sound(coupled_nodes(test::single_bubble()));
    expect_sound(coupled_nodes(honeycomb(1, 2)));
    expect_sound(coupled_nodes(honeycomb(1, 20)));
    expect_sound(coupled_nodes(honeycomb(20, 2)));
}

TEST(Dissection, KeepsSmallPartsWhole) {
    const CoupledNodes coupled = random_nodes(200, 1.0);
    const Dissection dissection = dissect(coupled);
    for (const DissectionPart& part : dissection.parts) {
        if (part.is_leaf()) {
            EXPECT_LE(rows_of(coupled, dissection, part), DissectionOptions().leaf_rows);
        }
    }
}

// A line through a foam crosses about one bubble per foam unit. For each bubble a separator
// contains three rows: the pressure of the bubble, and the two coordinates of the junction at which
// the line enters the next bubble. Two lines divide a torus of height 50: 2 * 50 * 3 = 300 rows.
// The lightest lines are not straight and have fewer rows.
TEST(Dissection, CutsATorusAlongTwoLightLines) {
    const CoupledNodes coupled = random_nodes(2500, 1.0);
    const Dissection dissection = dissect(coupled);
    EXPECT_LT(rows_of(coupled, dissection, dissection.parts.back()), 300);
}

// Returns the nodes of a square grid in the plane. Each has one row of the matrix and is coupled to
// the adjacent nodes.
CoupledNodes square_grid(int side, const Vec2& corner) {
    CoupledNodes grid{kPlane, {}, {}};
    grid.graph.begins.push_back(0);
    const auto connect = [&](int x, int y) {
        if (x >= 0 && x < side && y >= 0 && y < side) {
            grid.graph.neighbors.push_back(static_cast<std::uint32_t>(y * side + x));
        }
    };
    for (int k = 0; k < side * side; ++k) {
        const int x = k % side;
        const int y = k / side;
        grid.nodes.push_back({corner + Vec2(x, y), 1});
        connect(x - 1, y);
        connect(x + 1, y);
        connect(x, y - 1);
        connect(x, y + 1);
        grid.graph.begins.push_back(grid.graph.neighbors.size());
    }
    return grid;
}

// One line divides the grid. A torus of this size would need two lines.
TEST(Dissection, CutsThePlaneAlongOneLine) {
    const CoupledNodes coupled = square_grid(30, {-47.0, 8.0});
    expect_sound(coupled);
    const Dissection dissection = dissect(coupled);
    EXPECT_LE(rows_of(coupled, dissection, dissection.parts.back()), 30);
    const std::size_t left = subtree_begin(dissection, dissection.parts.back().right);
    EXPECT_NEAR(static_cast<double>(left), 450.0, 60.0);
}

TEST(Dissection, HalvesTheLongerSideFirst) {
    const CoupledNodes coupled = random_nodes(1600, 16.0);  // 160 x 10: lines of length 10
    const Dissection dissection = dissect(coupled);
    EXPECT_LT(rows_of(coupled, dissection, dissection.parts.back()), 2 * 10 * 3);
}

TEST(Dissection, BalancesTheHalves) {
    const CoupledNodes coupled = random_nodes(2500, 1.0);
    const Dissection dissection = dissect(coupled);
    const DissectionPart& root = dissection.parts.back();
    const std::size_t left = subtree_begin(dissection, root.right);
    EXPECT_NEAR(static_cast<double>(left) / static_cast<double>(root.begin), 0.5, 0.1);
}

// No two of the 40 nodes are coupled. Parts without nodes connect the leaves of the tree.
TEST(Dissection, PartsADisconnectedGraph) {
    const CoupledNodes coupled = nodes_in_row(std::vector<std::vector<std::uint32_t>>(40));
    expect_sound(coupled);
    EXPECT_GT(dissect(coupled).parts.size(), 2U);
}

TEST(Dissection, LeavesACompleteGraphWhole) {
    std::vector<std::vector<std::uint32_t>> others(40, std::vector<std::uint32_t>(39));
    for (std::uint32_t node = 0; node < 40; ++node) {
        std::iota(others[node].begin(), others[node].end(), 0U);
        std::iota(others[node].begin() + node, others[node].end(), node + 1);
    }
    const CoupledNodes coupled = nodes_in_row(others);
    expect_sound(coupled);
    EXPECT_EQ(dissect(coupled).parts.size(), 1U);
}

TEST(Dissection, NeedsNoUsefulPositions) {
    CoupledNodes coupled = random_nodes(100, 1.0);
    for (SolverNode& node : coupled.nodes) {
        node.position = Vec2(0.25, 0.75);
    }
    expect_sound(coupled);
}

TEST(Dissection, IsTheSameForAnyNumberOfThreads) {
    CoupledNodes coupled = random_nodes(1500, 1.0);
    const auto orders = [&](const DissectionOptions& options) {
        std::vector<std::vector<std::uint32_t>> found;
        for (const int threads : {1, 2, 3, 8}) {
            found.push_back(
                dissect(coupled.graph, coupled.nodes, coupled.domain, options, threads).order);
        }
        return found;
    };
    const auto expect_equal = [](const std::vector<std::vector<std::uint32_t>>& found) {
        for (const std::vector<std::uint32_t>& order : found) {
            EXPECT_EQ(order, found.front());
        }
    };
    expect_equal(orders({}));
    expect_equal(orders({.min_refined_rows = 1}));
    expect_equal(orders({.heaviest_separator = 0.0}));
}

TEST(Dissection, IsSoundIfTheGraphDecides) {
    CoupledNodes coupled = random_nodes(300, 1.0);
    for (const DissectionOptions& options :
         {DissectionOptions{.min_refined_rows = 1}, {.heaviest_separator = 0.0}}) {
        const Dissection dissection = dissect(coupled, options);
        EXPECT_TRUE(covers_every_node_once(dissection));
        EXPECT_EQ(couplings_across(coupled, dissection), 0);
    }
}

}  // namespace
}  // namespace foam
