// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/film_arcs.h"

#include "core/foam/frame.h"
#include "tests/support/sample_foams.h"
#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

TEST(FilmArcs, AreThoseOfTheFilms) {
    const Frame frame = snapshot(test::bent_foam(2500, 0.3, 3), 1);  // several tasks
    const std::vector<PixelArc> one = film_arcs(frame, 40.0, 1);
    const std::vector<PixelArc> two = film_arcs(frame, 40.0, 2);
    ASSERT_EQ(one.size(), frame.network.film_slots());
    for (const FilmId film : frame.network.films()) {
        const PixelArc& arc = one[index_of(film)];
        const PixelArc expected = pixel_arc(frame.arc(forward_side(film)));
        EXPECT_EQ(arc.chord, 40.0 * expected.chord);
        EXPECT_NEAR(arc.cosine, expected.cosine, 1e-14);
        EXPECT_NEAR(arc.sine, expected.sine, 1e-14);
        EXPECT_EQ(arc.sine, two[index_of(film)].sine);
    }
}

TEST(PixelArc, TurnsAsFarAsItsFilm) {
    for (const double half_angle : {-3.0, -1.0, 0.0, 1e-9, 0.3, 2.5}) {
        const FilmArc arc{{3.0, -4.0}, half_angle};
        EXPECT_NEAR(film_arc(pixel_arc(arc)).half_angle, half_angle, 1e-15);
        EXPECT_NEAR(film_arc(reversed(pixel_arc(arc))).half_angle, -half_angle, 1e-15);
        EXPECT_EQ(reversed(pixel_arc(arc)).chord, -arc.chord);
    }
}

TEST(HalfAngles, AreThoseOfTheLibraryToRounding) {
    constexpr int kSteps = 1000;
    at_every_simd_level([] {
        for (int step = -kSteps; step <= kSteps; ++step) {
            HalfAngles half_angles;
            half_angles.angle.fill(std::numbers::pi * step / kSteps);
            find_sines_and_cosines(half_angles);
            for (std::size_t k = 0; k < HalfAngles::kLanes; ++k) {
                ASSERT_NEAR(half_angles.cosine[k], std::cos(half_angles.angle[k]), 2e-14);
                ASSERT_NEAR(half_angles.sine[k], std::sin(half_angles.angle[k]), 2e-14);
            }
        }
    });
}

// Cosines must be exactly even and sines exactly odd, so that an arc is the same in both
// directions.
TEST(HalfAngles, AreEvenAndOdd) {
    HalfAngles positive;
    HalfAngles negative;
    for (std::size_t k = 0; k < HalfAngles::kLanes; ++k) {
        positive.angle[k] = 0.19 * static_cast<double>(k);
        negative.angle[k] = -positive.angle[k];
    }
    find_sines_and_cosines(positive);
    find_sines_and_cosines(negative);
    for (std::size_t k = 0; k < HalfAngles::kLanes; ++k) {
        EXPECT_EQ(positive.cosine[k], negative.cosine[k]);
        EXPECT_EQ(positive.sine[k], -negative.sine[k]);
    }
}

}  // namespace
}  // namespace foam::texgen
