// SPDX-License-Identifier: Apache-2.0

#include "texgen/mesh/edges.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Edges, ASquareOfTwoTrianglesHasFourUnpairedEdges) {
    const std::vector<Triangle> square = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<Edge> edges = sorted_edges(square);
    EXPECT_EQ(edges.size(), 6U);
    EXPECT_TRUE(are_distinct(edges));
    EXPECT_EQ(unpaired(edges),
              (std::vector<Edge>{
                  edge_between(0, 1), edge_between(1, 2), edge_between(2, 3), edge_between(3, 0)}));
    EXPECT_EQ(opposite(edge_between(7, 9)), edge_between(9, 7));
    EXPECT_EQ(start_of(edge_between(7, 9)), 7U);
    EXPECT_EQ(end_of(edge_between(7, 9)), 9U);
}

TEST(Edges, ATriangleThatOccursTwiceHasNoDistinctEdges) {
    const std::vector<Triangle> twice = {{0, 1, 2}, {0, 1, 2}};
    EXPECT_FALSE(are_distinct(sorted_edges(twice)));
}

}  // namespace
}  // namespace foam::texgen
