// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/step.h"
#include "core/io/evolver_file.h"
#include "core/io/foam_json.h"
#include "tests/core/foams.h"
#include "tests/core/io/small_torus.h"
#include "tests/core/patches.h"

#include <gtest/gtest.h>

#include <utility>

namespace foam {
namespace {

using test::kSmallState;

Foam read(const std::string& text) {
    return read_foam_json(text, "a.json");
}

void expect_rejected(std::string_view old, std::string_view replacement, const std::string& what) {
    test::expect_format_error([&] { read(test::edited(kSmallState, old, replacement)); }, what);
}

TEST(FoamJsonReader, ReadsBackToTheSameBits) {
    Foam foam = test::equilibrated_foam(50, 4);
    foam.time = 0.1;
    foam.pressures[BubbleId{3}] = -0.0;
    foam.t1_armed[FilmId{7}] = 0;
    const Foam again = read(write_foam_json(foam));
    EXPECT_TRUE(test::are_same(again, foam));
    EXPECT_EQ(write_foam_json(again), write_foam_json(foam));
}

// A foam that is written and read between any two steps evolves with the same bits, also through
// T1s and T2s.
TEST(FoamJsonReader, AnInterruptedFoamStepsToTheSameBits) {
    Foam foam = test::equilibrated_foam(80, 9);
    EquilibriumSummary events;
    for (int k = 0; k < 8; ++k) {
        Foam interrupted = read(write_foam_json(foam));
        const StepSummary summary = step(foam, 1.0, {});
        ASSERT_TRUE(summary.equilibrium.converged());
        step(interrupted, 1.0, {});
        ASSERT_TRUE(test::are_same(interrupted, foam)) << k;
        events.t1 += summary.equilibrium.t1;
        events.t2 += summary.equilibrium.t2;
    }
    EXPECT_GT(events.t1, 0);
    EXPECT_GT(events.t2, 0);
}

TEST(FoamJsonReader, IgnoresUnknownMembers) {
    const std::string text =
        test::edited(kSmallState, "\"torus\"", "\"note\": {\"by\": [\"me\"]},\n\"torus\"");
    EXPECT_TRUE(test::are_same(read(text), read(kSmallState)));
}

TEST(FoamJsonReader, RejectsOtherFormats) {
    expect_rejected(
        "foamtex-foam",
        "foam",
        "a.json:2: 'format': must be \"foamtex-foam\", otherwise the file is not a foam state");
    expect_rejected("1,\n\"torus\"",
                    "3,\n\"torus\"",
                    "a.json:3: 'version': foam state version 3 is not supported; this program "
                    "reads versions 1 to 2");
    expect_rejected("\"time\": 0.0,\n", "", "a.json:1: 'time' is missing");
    test::expect_format_error([] { read("[]"); }, "a.json:1: 'format' is missing");
}

TEST(FoamJsonReader, RejectsBadValues) {
    expect_rejected(
        "[3.0, 2.0]", "[3.0]", "a.json:4: 'torus': expected an array of 2 numbers, found 1");
    expect_rejected("[3.0, 2.0]",
                    "[3.0, -2.0]",
                    "a.json:4: 'torus', value 2: expected a positive number, found -2");
    expect_rejected(
        "0.5, 3]", "\"x\", 3]", "a.json:9: 'junctions'[0], value 2: expected a finite number");
    expect_rejected("0.5, 3]",
                    "2.5, 3]",
                    "a.json:9: 'junctions'[0]: the position (0, 2.5) is outside of the torus");
    expect_rejected("0.5, 3]",
                    "0.5, 6]",
                    "a.json:9: 'junctions'[0], value 3: expected an integer from 0 to 5, found 6");
    expect_rejected("0.5, 3]",
                    "0.5, 4]",
                    "a.json:9: 'junctions'[0], value 3: half-edge 4 does not leave junction 0");
    expect_rejected("[1, 0, 0, 0, 5",
                    "[1, 2, 0, 0, 5",
                    "a.json:14: 'films'[1], value 2: expected an integer from 0 to 1, found 2");
    expect_rejected("1, 1, 1],",
                    "1, 0.5, 1],",
                    "a.json:14: 'films'[1], value 8: expected an integer from -1000000 to 1000000, "
                    "found 0.5");
    expect_rejected("[0, 0.0, 6.0",
                    "[1, 0.0, 6.0",
                    "a.json:18: 'bubbles'[0], value 1: expected an identity below 1 (the value of "
                    "'next_identity'), found 1");
    expect_rejected(
        "\"films\": [", "\"films\": 3, \"old\": [", "a.json:12: 'films': expected an array");
}

// The time that functions of a sheared torus take grows with its width divided by its height.
TEST(FoamJsonReader, RejectsATorusOfExtremeShape) {
    expect_rejected("[3.0, 2.0]",
                    "[8e150, 8e-150, 1.0]",
                    "a.json:4: 'torus': the width and the height of the torus must differ by at "
                    "most the factor 16384, but are 8e+150 and 8e-150");
}

TEST(FoamJsonReader, RejectsReferencesToElementsOfAnEmptyList) {
    expect_rejected(
        "[\n[0.0, 0.5, 3],\n[1.0, 1.0, 4]\n]",
        "[]",
        "a.json:10: 'films'[0], value 1: refers to junction 0, but the file has no junction");
    expect_rejected(
        "[\n[0, 0.0, 6.0, 0, 6]\n]",
        "[]",
        "a.json:13: 'films'[0], value 3: refers to bubble 0, but the file has no bubble");
}

TEST(FoamJsonReader, RejectsInvalidFoams) {
    expect_rejected("5, 4, 1, 1, 1]",
                    "4, 4, 1, 1, 1]",
                    "a.json:12: 'films': the foam is not valid: half-edge 2 does not end where its "
                    "successor begins");
    expect_rejected(
        "6.0, 0, 6]",
        "6.0, 0, 5]",
        "a.json:12: 'films': the foam is not valid: bubble 0 has more sides than its stored count");
    expect_rejected(
        "6.0, 0, 6]",
        "6.1, 0, 6]",
        "a.json:17: 'bubbles': the target areas add up to 6.1, but the torus has an area of 6");
    const std::string twice = "[0, 0.0, 6.0, 0, 6],\n[0, 0.0, 6.0, 0, 6]";
    expect_rejected("[0, 0.0, 6.0, 0, 6]",
                    twice,
                    "a.json:19: 'bubbles'[1], value 1: duplicate bubble identity 0");
}

TEST(FoamJsonReader, KeepsAPatch) {
    for (Foam foam : {test::double_bubble(1.0, 2.0), test::flower(1.3), test::ring()}) {
        for (const FilmId film : foam.network.films()) {
            foam.half_angles[film] =
                foam.network.is_outer(film) ? 0.1 + 0.1 * static_cast<double>(index_of(film)) : 0.0;
        }
        foam.half_angles[FilmId{0}] = foam.network.is_outer(FilmId{0}) ? -2.75 : 0.0;
        foam.lone_bubbles.push_back({foam.next_identity++, {-1.5, 7.0}, 0.25});
        const std::string text = write_foam_json(foam);
        const Foam back = read(text);
        EXPECT_TRUE(test::are_same(back, foam));
        EXPECT_EQ(write_foam_json(back), text);
    }
}

TEST(FoamJsonReader, SortsLoneBubblesByIdentity) {
    Foam foam = test::double_bubble(1.0, 2.0);
    foam.next_identity = 9;
    foam.lone_bubbles = {{7, {0.0, 9.0}, 1.0}, {8, {9.0, 0.0}, 2.0}};
    Foam disordered = foam;
    std::swap(disordered.lone_bubbles[0], disordered.lone_bubbles[1]);
    EXPECT_TRUE(test::are_same(read(write_foam_json(disordered)), foam));
}

TEST(FoamJsonReader, RejectsInvalidPatches) {
    const std::string text = write_foam_json(test::double_bubble(1.0, 2.0));
    const auto reject = [&](std::string_view old, std::string_view replacement, const char* what) {
        test::expect_format_error([&] { read(test::edited(text, old, replacement)); }, what);
    };
    reject("\"ghost\": [", "\"spirit\": [", "a.json:1: 'ghost' is missing");
    reject("\"torus\": [0.0, 0.0]",
           "\"torus\": [0.0, 1.0]",
           "a.json:4: 'torus', value 1: expected a positive number, found 0");
}

}  // namespace
}  // namespace foam
