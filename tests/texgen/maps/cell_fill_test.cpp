// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_fill.h"

#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numbers>
#include <vector>

namespace foam::texgen {
namespace {

using test::LoneCircle;

// A pixel that the disc covers in part has the number of the covered part, 3. Such a pixel has its
// center at most half a diagonal of a pixel away from the rim, which has a radius of 20 pixels.
TEST(CellFill, PixelsOnTheRimHaveTheNumberOfTheCoveredPart) {
    const double half_diagonal = 0.5 * std::numbers::sqrt2;
    LoneCircle circle(20.0);
    const Image<float> image = fill_numbers(circle.layers, PerBubble<double>{3.0});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double distance = test::from_middle(x, y).norm();
            const float number = image.pixel(x, y)[0];
            EXPECT_TRUE(number == 3.0F || (number == 0.0F && distance > 20.0 - half_diagonal))
                << x << ", " << y;
            EXPECT_TRUE(number == 0.0F || distance < 20.0 + half_diagonal) << x << ", " << y;
        }
    }
}

TEST(CellFill, FilmsHaveANumberOfTheirOwn) {
    LoneCircle circle(20.0);
    const Image<float> image = fill_numbers(circle.layers, {{1.0}, 5.0}, 4.0);
    EXPECT_EQ(image.pixel(32, 32)[0], 1.0F);
    // The film is between 18 and 22 pixels from the middle. This pixel is 20.5 pixels from it.
    EXPECT_EQ(image.pixel(52, 32)[0], 5.0F);
}

TEST(CellFill, IdsAreNotMixed) {
    LoneCircle circle(20.0);
    const IdPixels ids = paint_ids(circle.layers, {9U});
    for (const std::uint32_t id : ids.pixels.samples()) {
        EXPECT_TRUE(id == 0U || id == 9U);
    }
    EXPECT_EQ(ids.pixels.pixel(32, 32)[0], 9U);
}

// The film of 4 pixels is a ring with the radii 18 and 22. The foam is the disc of radius 22.
TEST(CellFill, CoversAreAreas) {
    LoneCircle circle(20.0);
    const double films = test::sum_of(fill_coverage(circle.layers, Part::Films, 4.0));
    const double foam = test::sum_of(fill_coverage(circle.layers, Part::Foam, 4.0));
    EXPECT_NEAR(films, (22.0 * 22.0 - 18.0 * 18.0) * std::numbers::pi, 0.1);
    EXPECT_NEAR(foam, 22.0 * 22.0 * std::numbers::pi, 0.1);
}

// The value of the surroundings is between the values of the bubbles of the network and of the lone
// bubbles.
TEST(CellFill, ValuesByIdHaveTheSurroundingInBetween) {
    LoneCircle circle(20.0);
    EXPECT_EQ(by_cell_id(circle.layers.frame(), PerBubble<int>{7}, -1), (std::vector<int>{-1, 7}));
}

}  // namespace
}  // namespace foam::texgen
