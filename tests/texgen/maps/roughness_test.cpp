// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/roughness.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::LoneCircle;

TEST(Roughness, IsThatOfCellsAndFilms) {
    LoneCircle circle(20.0);
    const auto at = [&](int x, const RoughnessOptions& options) {
        return draw_roughness(circle.layers, options, test::films_of(4.0)).pixels.pixel(x, 32)[0];
    };
    EXPECT_NEAR(at(32, {.cell = 0.3, .film = 0.6, .variation = 0.0}), 0.3, 1e-5);
    EXPECT_NEAR(at(51, {.cell = 0.3, .film = 0.6, .variation = 0.0}), 0.6, 1e-5);
    EXPECT_NEAR(at(32, {.cell = 0.3, .film = 0.6, .variation = 0.2}), 0.3, 0.1);
    EXPECT_EQ(at(1, {}), 0.0F);
}

TEST(Roughness, LimitsHoldOnBothSides) {
    test::expect_limits(roughness_keys(),
                        {{"cell", "-0.1", "0", "1", "1.1"},
                         {"film", "-0.1", "0", "1", "1.1"},
                         {"variation", "-0.1", "0", "1", "1.1"}});
}

}  // namespace
}  // namespace foam::texgen
