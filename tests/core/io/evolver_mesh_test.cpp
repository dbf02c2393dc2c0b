// SPDX-License-Identifier: Apache-2.0

#include "core/io/evolver_mesh.h"

#include "tests/core/io/small_torus.h"

#include <gtest/gtest.h>

namespace foam::evolver {
namespace {

const std::string file_name = "a.fe";

Mesh mesh_of(const std::string& text) {
    TokenReader reader(text, file_name);
    const Header header = read_header(reader);
    return read_mesh(reader, header.parameters);
}

Mesh edited_mesh(std::string_view old, std::string_view replacement) {
    return mesh_of(test::edited(test::kSmallTorus, old, replacement));
}

void expect_rejected(std::string_view old, std::string_view replacement, const std::string& what) {
    test::expect_format_error([&] { edited_mesh(old, replacement); }, what);
}

TEST(EvolverMesh, ReadsTheFourSections) {
    const Mesh mesh = mesh_of(test::kSmallTorus);
    ASSERT_EQ(mesh.vertices.size(), 2U);
    EXPECT_EQ(mesh.vertices[1].point, Vec2(1.0, 1.0));
    EXPECT_EQ(mesh.vertices[1].line, 9);
    ASSERT_EQ(mesh.edges.size(), 3U);
    EXPECT_EQ(mesh.edges[1].tail, 1U);
    EXPECT_EQ(mesh.edges[1].head, 0U);
    EXPECT_TRUE(mesh.edges[1].wrap == (LatticeOffset{1, 1}));
    ASSERT_EQ(mesh.faces.size(), 1U);
    ASSERT_EQ(mesh.faces[0].sides.size(), 6U);
    EXPECT_EQ(mesh.faces[0].sides[2].edge, 2U);
    EXPECT_FALSE(mesh.faces[0].sides[2].forward);
    ASSERT_EQ(mesh.bodies.size(), 1U);
    EXPECT_EQ(mesh.bodies[0].volume, 6.0);
    EXPECT_FALSE(mesh.bodies[0].pressure.has_value());
    EXPECT_EQ(mesh.constrained_count, 0);
    EXPECT_EQ(mesh.end_line, 18);
}

TEST(EvolverMesh, IdsNeedNotBeContiguous) {
    std::string text = test::edited(test::kSmallTorus, "2 1 1\n", "2147483647 1 1\n");
    text = test::edited(text, "1 1 2 * *", "1 1 2147483647 * *");
    text = test::edited(text, "2 2 1 + +", "2 2147483647 1 + +");
    text = test::edited(text, "3 2 1 + *", "3 2147483647 1 + *");
    EXPECT_EQ(mesh_of(text).edges[2].tail, 1U);
}

TEST(EvolverMesh, ReadsEveryFormOfAWrap) {
    for (const char* wrap :
         {"+-", "+ -", "* * wrap 1985", "wrap 1985", "wrap 0x0007c1\n  color 3"}) {
        const Mesh mesh = edited_mesh("2 2 1 + +", std::string("2 2 1 ") + wrap);
        EXPECT_TRUE(mesh.edges[1].wrap == (LatticeOffset{1, -1})) << wrap;
    }
    EXPECT_TRUE(edited_mesh("+ +", "wrap 2").edges[1].wrap == (LatticeOffset{2, 0}));
    EXPECT_FALSE(edited_mesh("+ +", "").edges[1].wrap.has_value());
}

TEST(EvolverMesh, IgnoresMidpointsAndAttributes) {
    const Mesh mesh = edited_mesh("2 2 1 + +", "2 2 1 /*midpt*/ 2 + + original 7 color red fixed");
    EXPECT_TRUE(mesh.edges[1].wrap == (LatticeOffset{1, 1}));
    EXPECT_EQ(mesh.constrained_count, 1);
    EXPECT_EQ(
        edited_mesh("2 1 1\n", "2 1 1 constraints 1 2 foo { 1, 2} original -3\n").constrained_count,
        1);
}

TEST(EvolverMesh, ReadsTensionsAndPressures) {
    EXPECT_EQ(edited_mesh("+ +", "+ + density 2.5").edges[1].tension, 2.5);
    EXPECT_EQ(edited_mesh("+ +", "+ + tension 1/2").edges[1].tension, 0.5);
    const Mesh mesh = edited_mesh(
        "volume 6", "volume 5+1 /*actual: 6*/ lagrange_multiplier -2e-319 centerofmass volconst 6");
    EXPECT_EQ(mesh.bodies[0].volume, 6.0);
    EXPECT_EQ(mesh.bodies[0].pressure, -2e-319);
}

TEST(EvolverMesh, LongFacesContinueAfterABackslash) {
    EXPECT_EQ(edited_mesh("-3 -1 -2", "-3 -1 \\\n -2").faces[0].sides.size(), 6U);
}

TEST(EvolverMesh, EndsAtRead) {
    std::string text(test::kSmallTorus);
    text += "READ\nM 2; \"never closed\n/* nor";
    EXPECT_EQ(mesh_of(text).end_line, 18);
}

TEST(EvolverMesh, RejectsMissingSections) {
    expect_rejected("faces     // 14\n1 1 2 -3 -1 -2 3\n",
                    "",
                    "a.fe:14: expected a section 'faces', found 'bodies'");
    test::expect_format_error([] { mesh_of("STRING SPACE_DIMENSION 2 TORUS vertices"); },
                              "a.fe:1: expected a section 'edges', found the end of the file");
    test::expect_format_error([] { mesh_of(std::string(test::kSmallTorus) + "edges\n"); },
                              "a.fe:18: expected 'read' or the end of the file, found 'edges'");
}

TEST(EvolverMesh, RejectsBadNumbersOfElements) {
    expect_rejected("2 1 1\n", "1 1 1\n", "a.fe:9: duplicate vertex 1");
    expect_rejected("2 1 1\n", "0 1 1\n", "a.fe:9: vertex numbers must be at least 1, not 0");
    expect_rejected("2 2 1 + +",
                    "2 2 9 + +",
                    "a.fe:12: edge 2 refers to vertex 9, which the file does not define");
    expect_rejected(
        "1 1 2 -3", "1 1 2 -8", "a.fe:15: face 1 refers to edge 8, which the file does not define");
    expect_rejected("1 1 volume",
                    "1 4 volume",
                    "a.fe:17: body 1 refers to face 4, which the file does not define");
    expect_rejected("2 2 1 + +",
                    "2 2 1 99 + +",
                    "a.fe:12: edge 2 refers to vertex 99, which the file does not define");
}

TEST(EvolverMesh, RejectsIncompleteElements) {
    expect_rejected("2 1 1\n", "2 1\n", "a.fe:9: vertex 2: expected two coordinates");
    expect_rejected(
        "2 1 1\n", "2 1 1 7\n", "a.fe:9: expected an attribute or the end of the line, found '7'");
    expect_rejected("2 2 1 + +",
                    "2 2 1 +",
                    "a.fe:13: expected a second wrap symbol, '*', '+' or '-', "
                    "found '3'");
    expect_rejected("1 1 2 -3 -1 -2 3\n", "1\n", "a.fe:15: face 1 has no edges");
    expect_rejected("volume 6", "volume", "a.fe:18: expected a number, found the end of the file");
}

TEST(EvolverMesh, RejectsBodiesThatAreNoBubbles) {
    expect_rejected("1 1 volume 6", "1 1 1 volume 6", "a.fe:17: body 1 has more than one face");
    expect_rejected("volume 6\n", "volume 6\n2 1\n", "a.fe:18: body 2: face 1 already has a body");
}

// Evolver rejects a body with a volume and a pressure: "Body can't have fixed volume and fixed
// pressure".
TEST(EvolverMesh, RejectsPrescribedPressures) {
    for (const char* attributes : {"pressure 6",
                                   "volume 6 pressure 2",
                                   "pressure 2 volume 6",
                                   "volume 6 pressure 2 lagrange_multiplier 3",
                                   "pressure 2 lagrange_multiplier 3"}) {
        expect_rejected("volume 6",
                        attributes,
                        "a.fe:17: body 1: a prescribed pressure is not supported; give a volume, "
                        "and the pressure as lagrange_multiplier");
    }
}

TEST(EvolverMesh, RejectsBoundaries) {
    expect_rejected(
        "2 1 1\n", "2 1 1 boundary 1\n", "a.fe:9: vertex 2: boundaries are not supported");
    expect_rejected("+ +", "+ + boundary 1", "a.fe:12: edge 2: boundary is not supported");
}

}  // namespace
}  // namespace foam::evolver
