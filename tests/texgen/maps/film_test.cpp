// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film.h"

#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <numbers>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// The film is a ring with the radii 18.5 and 21.5 pixels, so its area is 120 pi.
TEST(Film, HasTheAreaOfARing) {
    LoneCircle circle(20.0);
    const NumberPixels film = draw_film(circle.layers, test::films_of(3.0));
    EXPECT_NEAR(test::sum_of(film.pixels), 120.0 * std::numbers::pi, 0.05);
    EXPECT_EQ(film.pixels.pixel(32, 32)[0], 0.0F);
    EXPECT_EQ(film.pixels.pixel(0, 0)[0], 0.0F);
}

}  // namespace
}  // namespace foam::texgen
