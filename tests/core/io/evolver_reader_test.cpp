// SPDX-License-Identifier: Apache-2.0

#include "core/foam/honeycomb.h"
#include "core/foam/measure.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/core/foams.h"
#include "tests/core/io/small_torus.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <regex>

namespace foam {
namespace {

EvolverFoam edited_foam(std::string_view old, std::string_view replacement) {
    return read_evolver(test::edited(test::kSmallTorus, old, replacement), "a.fe");
}

void expect_rejected(std::string_view old, std::string_view replacement, const std::string& what) {
    test::expect_format_error([&] { edited_foam(old, replacement); }, what);
}

// Two bubbles: the face of the small torus (small_torus.h), and a two-sided bubble in its first
// edge.
constexpr const char* kLensTorus = R"(STRING
SPACE_DIMENSION 2
TORUS_FILLED
PERIODS
3 0
0 2
vertices
1 0 0.5
2 1 1
3 0.25 0.625
4 0.75 0.875
edges
1 1 3 * *
2 2 1 + +
3 2 1 + *
4 4 2 * *
5 3 4 * *
6 3 4 * *
faces
1 1 5 4 2 -3 -4 -6 -1 -2 3
2 6 -5
bodies
1 1 volume 5.75
2 2 volume 0.25
)";

TEST(EvolverReader, ReadsOneBubble) {
    const EvolverFoam read = read_evolver(test::kSmallTorus, "a.fe");
    const Foam& foam = read.foam;
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.domain.width, 3.0);
    EXPECT_EQ(foam.domain.height, 2.0);
    EXPECT_EQ(foam.film_tension, 1.0);
    EXPECT_EQ(foam.network.junction_count(), 2U);
    EXPECT_EQ(foam.network.film_count(), 3U);
    EXPECT_EQ(foam.network.bubble_count(), 1U);
    EXPECT_EQ(foam.positions[JunctionId{1}], Vec2(1.0, 1.0));
    EXPECT_EQ(chord(foam, forward_side(FilmId{1})), Vec2(2.0, 1.5));
    EXPECT_EQ(foam.target_areas[BubbleId{0}], 6.0);
    EXPECT_EQ(foam.pressures[BubbleId{0}], 0.0);
    EXPECT_EQ(foam.next_identity, 1U);
    EXPECT_EQ(foam.t1_armed[FilmId{2}], 1);
    EXPECT_TRUE(read.notes.empty());
}

TEST(EvolverReader, WrapsJunctionsFromAnywhere) {
    std::string text = test::edited(test::kSmallTorus, "2 1 1\n", "2 4 -1\n");  // moved by (1, -1)
    text = test::edited(text, "1 1 2 * *", "1 1 2 - +");
    text = test::edited(text, "2 2 1 + +", "2 2 1 wrap 2");
    text = test::edited(text, "3 2 1 + *", "3 2 1 wrap 1986");  // wrap (2, -1)
    const Foam moved = read_evolver(text, "a.fe").foam;
    EXPECT_TRUE(test::are_same(moved, read_evolver(test::kSmallTorus, "a.fe").foam));
}

// The periods (3, 0) and (6.5, 2) describe the same lattice as (3, 0) and (0.5, 2). A JSON state
// stores only shears of at most the width.
TEST(EvolverReader, ReducesPeriods) {
    const Foam foam = edited_foam("0 2\nvertices", "6.5 2\nvertices").foam;
    EXPECT_EQ(foam.domain.shear, 0.5);
    EXPECT_EQ(foam.network.offset(HalfEdgeId{2}).i, 3);  // the wrap + + is 1 + 2 widths
    EXPECT_EQ(foam.network.offset(HalfEdgeId{2}).j, 1);
    EXPECT_EQ(write_foam_json(read_foam_json(write_foam_json(foam), "a.json")),
              write_foam_json(foam));
}

TEST(EvolverReader, RejectsAShearOfMillionsOfWidths) {
    expect_rejected(
        "0 2\nvertices",
        "1e9 2\nvertices",
        "a.fe:4: the x component of the second period is 1000000000; its magnitude must be "
        "at most 1000000 times the width of the torus, which is 3");
}

TEST(EvolverReader, ReadsTwoSidedBubbles) {
    const Foam foam = read_evolver(kLensTorus, "a.fe").foam;
    EXPECT_TRUE(test::is_valid(foam.network));
    EXPECT_EQ(foam.network.sides(BubbleId{0}), 10);
    EXPECT_EQ(foam.network.sides(BubbleId{1}), 2);
    EXPECT_EQ(foam.target_areas[BubbleId{1}], 0.25);
}

TEST(EvolverReader, WithoutWrapsFilmsGoToTheNearestCopy) {
    const Foam honey = honeycomb(4, 4);
    const std::string text = write_evolver(honey, EvolverEdges::Straight);
    const std::string bare = std::regex_replace(text, std::regex(" [-+*] [-+*]\n"), "\n");
    ASSERT_NE(bare, text);
    EXPECT_TRUE(test::are_same(read_evolver(bare, "a.fe").foam, read_evolver(text, "a.fe").foam));
}

// The period (shear, height) is (1e6 width, height), so that (0, height) is also a period.
TEST(EvolverReader, FilmsOfAStronglyShearedTorusMayLeadFarAway) {
    const Foam honey = honeycomb(4, 4);
    std::string text = write_evolver(honey, EvolverEdges::Straight);
    text = std::regex_replace(text, std::regex(" [-+*] [-+*]\n"), "\n");
    const double height = honey.domain.height;
    text = test::edited(text,
                        fmt::format("0 {}\n", height),
                        fmt::format("{} {}\n", 1e6 * honey.domain.width, height));
    const Vec2 first = honey.positions[JunctionId{0}];
    text = test::edited(text,
                        fmt::format("\n1 {} {}\n", first.x(), first.y()),
                        fmt::format("\n1 {} {}\n", first.x(), first.y() + 5000.0 * height));
    const Foam foam = read_evolver(text, "a.fe").foam;
    EXPECT_EQ(foam.domain.shear, 0.0);
    for (const FilmId film : honey.network.films()) {
        const HalfEdgeId h = forward_side(film);
        EXPECT_TRUE(foam.network.offset(h) == honey.network.offset(h));
        EXPECT_LT((chord(foam, h) - chord(honey, h)).norm(), 1e-9);
    }
}

TEST(EvolverReader, ReadsPressuresAndTensions) {
    const EvolverFoam read = edited_foam("volume 6", "volume 6 lagrange_multiplier 0.75");
    EXPECT_EQ(read.foam.pressures[BubbleId{0}], 0.75);
    std::string text = test::edited(test::kSmallTorus, "1 1 2 * *", "1 1 2 * * tension 2");
    test::expect_format_error(
        [&] { read_evolver(text, "a.fe"); },
        "a.fe:12: edge 2 has tension 1, but edge 1 has 2; all films must have the same tension");
    text = test::edited(text, "2 2 1 + +", "2 2 1 + + density 2");
    text = test::edited(text, "3 2 1 + *", "3 2 1 + * tension 1+1");
    EXPECT_EQ(read_evolver(text, "a.fe").foam.film_tension, 2.0);
    text = test::edited(text, "STRING", "STRING quantity q energy global_method edge_length");
    EXPECT_EQ(read_evolver(text, "a.fe").foam.film_tension, 3.0);
    text = test::edited(text, "edge_length", "edge_length modulus 1e200");
    text = test::edited(text, "energy", "energy modulus 1e200");
    test::expect_format_error([&] { read_evolver(text, "a.fe"); },
                              "a.fe:11: the film tension must be positive and finite, not inf");
}

TEST(EvolverReader, OneVolumeMayBeMissing) {
    const std::string text = test::edited(kLensTorus, "2 2 volume 0.25\n", "");
    EXPECT_EQ(read_evolver(text, "a.fe").foam.target_areas[BubbleId{1}], 0.25);
    const std::string full = test::edited(text, "volume 5.75", "volume 6");
    test::expect_format_error(
        [&] { read_evolver(full, "a.fe"); },
        "a.fe:21: face 2 has no volume; the area computed for it is 0, but must be positive");
}

TEST(EvolverReader, WithoutVolumesBubblesKeepTheirAreas) {
    const EvolverFoam read = edited_foam(" volume 6", "");
    EXPECT_DOUBLE_EQ(read.foam.target_areas[BubbleId{0}], 6.0);
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(read.notes[0],
              "no body has a volume; each bubble keeps the area of its straight-edged polygon");
}

TEST(EvolverReader, RoundedVolumesAreBroughtToTheSum) {
    EXPECT_DOUBLE_EQ(edited_foam("volume 6", "volume 6.00001").foam.target_areas[BubbleId{0}], 6.0);
    EXPECT_EQ(edited_foam("volume 6", "volume 6.000000000001").foam.target_areas[BubbleId{0}],
              6.000000000001);
    expect_rejected("volume 6",
                    "volume 6.001",
                    "a.fe:18: the volumes add up to 6.001, but the torus has an area of 6");
    expect_rejected("volume 6", "volume 0", "a.fe:17: body 1: the volume must be positive, not 0");
    expect_rejected(
        "volume 6", "volume -6", "a.fe:17: body 1: the volume must be positive, not -6");
}

TEST(EvolverReader, NotesFixedElements) {
    const EvolverFoam read = edited_foam("2 1 1\n", "2 1 1 fixed\n");
    ASSERT_EQ(read.notes.size(), 1U);
    EXPECT_EQ(read.notes[0], "fixed positions and constraints of 1 element are ignored");
}

TEST(EvolverReader, RejectsFacesThatMakeNoFoam) {
    EXPECT_THROW(edited_foam("1 1 2 -3 -1 -2 3\n", "1 1 2 1\n"), FormatError);
    EXPECT_THROW(edited_foam("1 1 2 -3 -1 -2 3\n", "1 1 3 -3 -1\n2 2 -2\n"), FormatError);
}

}  // namespace
}  // namespace foam
