// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_loops.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

namespace foam::evolver {
namespace {

const std::string file_name = "a.fe";

std::vector<FilmLoop> loops_of(const std::string& text) {
    TokenReader reader(text, file_name);
    const Header header = read_header(reader);
    const Mesh mesh = read_mesh(reader, header.parameters);
    return film_loops(mesh, header.domain, file_name);
}

void expect_rejected(std::string_view old, std::string_view replacement, const std::string& what) {
    test::expect_format_error([&] { loops_of(test::edited(test::kSmallTorus, old, replacement)); },
                              what);
}

// Returns the edges around the first face, from its first edge. An edge that is traversed from head
// to tail is negative.
std::vector<int> edges_around(const std::string& text) {
    const std::vector<FilmLoop> loops = loops_of(text);
    std::vector<int> edges;
    for (const FilmSide& film : loops.front().films) {
        const int id = static_cast<int>(film.first.edge) + 1;
        edges.push_back(film.first.forward ? id : -id);
    }
    return edges;
}

TEST(EvolverLoops, AFaceIsALoopOfFilms) {
    const std::vector<FilmLoop> loops = loops_of(test::kSmallTorus);
    ASSERT_EQ(loops.size(), 1U);
    ASSERT_EQ(loops[0].films.size(), 6U);
    EXPECT_DOUBLE_EQ(loops[0].polygon_area, 6.0);
    EXPECT_EQ(edges_around(test::kSmallTorus), (std::vector<int>{1, 2, -3, -1, -2, 3}));
    EXPECT_TRUE(loops[0].films[1].offset == (LatticeOffset{1, 1}));
    EXPECT_TRUE(loops[0].films[4].offset == (LatticeOffset{-1, -1}));
}

TEST(EvolverLoops, ClockwiseFacesAreTurnedAround) {
    const std::string clockwise =
        test::edited(test::kSmallTorus, "1 1 2 -3 -1 -2 3\n", "1 -3 2 1 3 -2 -1\n");
    EXPECT_EQ(edges_around(clockwise), (std::vector<int>{1, 2, -3, -1, -2, 3}));
    EXPECT_DOUBLE_EQ(loops_of(clockwise)[0].polygon_area, 6.0);
    EXPECT_EQ(edges_around(test::edited(clockwise, "1 1 volume", "1 -1 volume")),
              (std::vector<int>{1, 2, -3, -1, -2, 3}));
}

TEST(EvolverLoops, VerticesOfTwoEdgesAreDissolved) {
    // The middle of edge 2, translated by a period, becomes a vertex that divides edge 2 into the
    // edges 2 and 4.
    std::string text = test::edited(test::kSmallTorus, "2 1 1\n", "2 1 1\n3 5 1.75\n");
    text = test::edited(text, "2 2 1 + +", "2 2 3 - *");
    text = test::edited(text, "3 2 1 + *", "3 2 1 + *\n4 3 1 wrap 66");  // wrap (2, 1)
    text = test::edited(text, "1 1 2 -3 -1 -2 3\n", "1 4 -3 -1 -4 -2 3 1 2\n");
    const std::vector<FilmLoop> loops = loops_of(text);
    EXPECT_EQ(edges_around(text), (std::vector<int>{-3, -1, -4, 3, 1, 2}));
    EXPECT_DOUBLE_EQ(loops[0].polygon_area, 6.0);
    EXPECT_EQ(loops[0].films[5].last.edge, 3U);
    EXPECT_TRUE(loops[0].films[5].offset == (LatticeOffset{1, 1}));
}

TEST(EvolverLoops, RejectsOpenLoops) {
    expect_rejected("1 1 2 -3",
                    "1 1 -3 2",
                    "a.fe:15: face 1: edge 3 does not begin where edge 1 "
                    "ends");
    expect_rejected("+ *", "+ -", "a.fe:18: the faces do not cover the torus exactly once");
    expect_rejected("1 1 2 -3 -1 -2 3\n",
                    "1 1 2\n",
                    "a.fe:15: face 1: the wraps of its edges must add up to zero");
}

TEST(EvolverLoops, RejectsEdgesThatAreNotBetweenTwoFaces) {
    expect_rejected("1 1 2 -3 -1 -2 3\n",
                    "1 1 3 -3 -1 1 3 -3 -1\n",
                    "a.fe:15: face 1: edge 1 already has a face on that side");
    expect_rejected(
        "1 1 2 -3 -1 -2 3\n", "1 1 2 -2 -1\n", "a.fe:13: edge 3 has no face on either side");
}

TEST(EvolverLoops, RejectsJunctionsOfMoreOrFewerFilms) {
    const std::string squares =
        "STRING SPACE_DIMENSION 2 TORUS\nvertices\n1 0 0\n"
        "edges\n1 1 1 + *\n2 1 1 * +\nfaces\n1 1 2 -1 -2\n"
        "bodies\n1 1 volume 1\n";
    test::expect_format_error([&] { loops_of(squares); },
                              "a.fe:3: vertex 1 joins 4 edges; must join two or three");
    // An edge ends inside the bubble.
    std::string text = test::edited(test::kSmallTorus, "2 1 1\n", "2 1 1\n3 1 1.5\n");
    text = test::edited(text, "3 2 1 + *", "3 2 1 + *\n4 2 3 * *");
    text = test::edited(text, "1 1 2 -3 -1 -2 3\n", "1 1 4 -4 2 -3 -1 -2 3\n");
    test::expect_format_error([&] { loops_of(text); },
                              "a.fe:9: vertex 2 joins 4 edges; must join two or three");
    text = test::edited(text, "4 2 3 * *", "4 3 3 * *");
    text = test::edited(text, "1 1 4 -4 2", "1 1 2");
    text = test::edited(text, "bodies", "2 4\n3 -4\nbodies");
    test::expect_format_error([&] { loops_of(text); },
                              "a.fe:18: face 2 has no vertex that joins three edges");
}

TEST(EvolverLoops, RejectsFacesThatLeadFarAway) {
    expect_rejected("0 2\nvertices",
                    "3e6 2\nvertices",
                    "a.fe:15: face 1: its edges lead more than 1000000 periods away from its first "
                    "vertex");
}

TEST(EvolverLoops, RejectsVerticesFarAway) {
    expect_rejected("2 1 1\n",
                    "2 1 1e99\n",
                    "a.fe:9: vertex 2 is too far from the origin; must be within 1000000 periods");
}

}  // namespace
}  // namespace foam::evolver
