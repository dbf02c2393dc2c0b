// SPDX-License-Identifier: Apache-2.0

#include "core/sparse/vertex_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <utility>
#include <vector>

namespace foam {
namespace {

struct CutProblem {
    std::vector<int> weights;
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    std::vector<std::size_t> sources;
    std::vector<std::size_t> sinks;
};

std::vector<CutSide> solve(VertexCut& cut, const CutProblem& problem) {
    cut.reset(problem.weights.size());
    for (std::size_t node = 0; node < problem.weights.size(); ++node) {
        cut.set_weight(node, problem.weights[node]);
    }
    for (const std::size_t node : problem.sources) {
        cut.make_source(node);
    }
    for (const std::size_t node : problem.sinks) {
        cut.make_sink(node);
    }
    for (const auto& [a, b] : problem.pairs) {
        cut.connect(a, b);
        cut.connect(b, a);
    }
    return cut.solve();
}

int weight_of_cut(const CutProblem& problem, const std::vector<CutSide>& sides) {
    int weight = 0;
    for (std::size_t node = 0; node < sides.size(); ++node) {
        weight += sides[node] == CutSide::Cut ? problem.weights[node] : 0;
    }
    return weight;
}

// Returns true if no source is behind the cut, no sink is in front of it, and no connection crosses
// it.
bool is_cut(const CutProblem& problem, const std::vector<CutSide>& sides) {
    for (const std::size_t node : problem.sources) {
        if (sides[node] == CutSide::Sink) {
            return false;
        }
    }
    for (const std::size_t node : problem.sinks) {
        if (sides[node] == CutSide::Source) {
            return false;
        }
    }
    for (const auto& [a, b] : problem.pairs) {
        if (std::pair(sides[a], sides[b]) == std::pair(CutSide::Source, CutSide::Sink) ||
            std::pair(sides[a], sides[b]) == std::pair(CutSide::Sink, CutSide::Source)) {
            return false;
        }
    }
    return true;
}

// Returns the weight of the lightest cut, by trying all 3^n assignments of nodes to sides.
int lightest_by_trial(const CutProblem& problem) {
    std::vector<CutSide> sides(problem.weights.size(), CutSide::Source);
    int lightest = weight_of_cut(problem, std::vector(sides.size(), CutSide::Cut));
    while (true) {
        if (is_cut(problem, sides)) {
            lightest = std::min(lightest, weight_of_cut(problem, sides));
        }
        std::size_t node = 0;
        while (node < sides.size() && sides[node] == CutSide::Sink) {
            sides[node++] = CutSide::Source;
        }
        if (node == sides.size()) {
            return lightest;
        }
        sides[node] = sides[node] == CutSide::Source ? CutSide::Cut : CutSide::Sink;
    }
}

CutProblem random_problem(std::mt19937& random) {
    constexpr std::size_t kNodes = 8;
    CutProblem problem;
    for (std::size_t a = 0; a < kNodes; ++a) {
        problem.weights.push_back(1 + static_cast<int>(random() % 2));
        for (std::size_t b = 0; b < a; ++b) {
            if (random() % 3 == 0) {
                problem.pairs.emplace_back(a, b);
            }
        }
    }
    problem.sources = {0, 1};
    problem.sinks = {kNodes - 1, kNodes - 2};
    return problem;
}

// In the chain 0-1-2-3-4, node 2 is the lightest.
TEST(VertexCut, TakesTheLightestNodeOfAChain) {
    VertexCut cut;
    const CutProblem chain{{3, 2, 1, 2, 3}, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, {0}, {4}};
    EXPECT_EQ(solve(cut, chain),
              (std::vector{
                  CutSide::Source, CutSide::Source, CutSide::Cut, CutSide::Sink, CutSide::Sink}));
}

TEST(VertexCut, TakesOfEquallyLightCutsTheOneNextToTheSources) {
    VertexCut cut;
    const CutProblem chain{{1, 1, 1}, {{0, 1}, {1, 2}}, {0}, {2}};
    EXPECT_EQ(solve(cut, chain), (std::vector{CutSide::Cut, CutSide::Sink, CutSide::Sink}));
}

// Two columns of three nodes each. Each node of the left column is coupled to the opposite node and
// to the node below that. The left column weighs 6 and the right column 5, but the two lower nodes
// of the right column and the upper node of the left column weigh 4.
TEST(VertexCut, MayRunThroughSourcesAndSinks) {
    VertexCut cut;
    const CutProblem columns{
        {1, 2, 3, 2, 1, 2}, {{0, 3}, {1, 4}, {2, 5}, {0, 4}, {1, 5}}, {0, 1, 2}, {3, 4, 5}};
    const std::vector<CutSide> sides = solve(cut, columns);
    EXPECT_TRUE(is_cut(columns, sides));
    EXPECT_EQ(weight_of_cut(columns, sides), 4);
}

TEST(VertexCut, NeedsNoNodeBetweenComponents) {
    VertexCut cut;
    const CutProblem apart{{1, 1}, {}, {0}, {1}};
    EXPECT_EQ(solve(cut, apart), (std::vector{CutSide::Source, CutSide::Sink}));
    EXPECT_TRUE(solve(cut, {}).empty());
}

TEST(VertexCut, IsAsLightAsTheLightestByTrial) {
    std::mt19937 random(1);
    VertexCut cut;
    for (int trial = 0; trial < 60; ++trial) {
        const CutProblem problem = random_problem(random);
        const std::vector<CutSide> sides = solve(cut, problem);
        EXPECT_TRUE(is_cut(problem, sides)) << "trial " << trial;
        EXPECT_EQ(weight_of_cut(problem, sides), lightest_by_trial(problem)) << "trial " << trial;
    }
}

}  // namespace
}  // namespace foam
