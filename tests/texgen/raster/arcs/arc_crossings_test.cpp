// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/arcs/arc_crossings.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <vector>

namespace foam::texgen {
namespace {

// The largest errors, in subpixels, of the crossings of 300 random arcs with lines that are a pixel
// apart. `of_xs` is for horizontal lines, `of_ys` for vertical lines. If an arc is steeper than 45
// degrees, the error of y is divided by its slope. `length` is the largest width and height of the
// arcs in pixels.
class LargestErrors {
  public:
    explicit LargestErrors(double length) {
        for (int k = 0; k < 300; ++k) {
            add(length);
        }
    }

    double of_xs = 0.0;
    double of_ys = 0.0;

  private:
    void add(double length) {
        std::uniform_real_distribution<double> side(length / 8, length);
        const SubpixelPoint head{to_subpixel(side(random_)), to_subpixel(side(random_))};
        // The arc is monotone in x and in y.
        const double steep = std::atan2(std::min(head.x, head.y), std::max(head.x, head.y));
        const double sine = std::sin(std::uniform_real_distribution(-steep, steep)(random_));
        const RoundedCrossings arc(head, sine);
        const CrossingSolver<double> exact(Vec2(head.x, head.y), sine);
        const std::int32_t rows = head.y / kSubpixel;
        const std::int32_t columns = head.x / kSubpixel;
        std::vector<std::int32_t> found(static_cast<std::size_t>(std::max(rows, columns)) +
                                        CrossingQuery::kLanes);
        CrossingQuery query{.arc = arc, .first = kSubpixel / 2, .step = kSubpixel, .offset = 7};
        query.sign = -1;
        query.count = static_cast<std::size_t>(rows);
        find_xs({&query, 1}, found.data());
        for (std::int32_t row = 0; row < rows; ++row) {
            const std::int32_t y = row * kSubpixel + kSubpixel / 2;
            const std::int32_t x = -found[static_cast<std::size_t>(row)] - 7;
            ASSERT_EQ(x, arc.x_at(y));
            of_xs = std::max(of_xs, std::abs(x - exact.x_at(y)));
        }
        query.count = static_cast<std::size_t>(columns);
        find_ys({&query, 1}, found.data());
        for (std::int32_t column = 0; column < columns; ++column) {
            const std::int32_t x = column * kSubpixel + kSubpixel / 2;
            const std::int32_t y = -found[static_cast<std::size_t>(column)] - 7;
            const double here = exact.y_at(x);
            const double slope = (exact.y_at(x + 1) - exact.y_at(x - 1)) / 2;
            of_ys = std::max(of_ys, std::abs(y - here) / std::max(std::abs(slope), 1.0));
        }
    }

    std::mt19937 random_{5};
};

TEST(ArcCrossings, AreRoundedToTheNearest) {
    at_every_simd_level([] {
        for (const double length : {1.5, 20.0, 256.0}) {
            const LargestErrors errors(length);
            EXPECT_LT(errors.of_xs, 0.6) << length;
            EXPECT_LT(errors.of_ys, 0.6) << length;
        }
    });
}

// In floats, the crossings of arcs of this length would be wrong by several subpixels.
TEST(ArcCrossings, OfLongArcsAreAsAccurate) {
    at_every_simd_level([] {
        const LargestErrors errors(16000.0);
        EXPECT_LT(errors.of_xs, 0.5 + 1e-6);
        EXPECT_LT(errors.of_ys, 0.5 + 1e-6);
    });
}

}  // namespace
}  // namespace foam::texgen
