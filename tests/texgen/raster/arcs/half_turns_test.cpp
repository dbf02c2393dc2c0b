#include "texgen/raster/arcs/half_turns.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foam::texgen {
namespace {

TEST(HalfTurns, AreThoseOfTheLibraryToRounding) {
    constexpr int kSteps = 1000;
    at_every_simd_level([] {
        for (int step = -kSteps; step <= kSteps; ++step) {
            HalfTurns turns;
            turns.angle.fill(std::numbers::pi * step / kSteps);
            find_turns(turns);
            for (std::size_t k = 0; k < HalfTurns::kLanes; ++k) {
                ASSERT_NEAR(turns.cosine[k], std::cos(turns.angle[k]), 2e-14);
                ASSERT_NEAR(turns.sine[k], std::sin(turns.angle[k]), 2e-14);
            }
        }
    });
}

// So that an arc is the same from both its sides.
TEST(HalfTurns, AreEvenAndOdd) {
    HalfTurns there;
    HalfTurns back;
    for (std::size_t k = 0; k < HalfTurns::kLanes; ++k) {
        there.angle[k] = 0.19 * static_cast<double>(k);
        back.angle[k] = -there.angle[k];
    }
    find_turns(there);
    find_turns(back);
    for (std::size_t k = 0; k < HalfTurns::kLanes; ++k) {
        EXPECT_EQ(there.cosine[k], back.cosine[k]);
        EXPECT_EQ(there.sine[k], -back.sine[k]);
    }
}

}  // namespace
}  // namespace foam::texgen
