// SPDX-License-Identifier: Apache-2.0

#include "core/foam/random.h"

#include <gtest/gtest.h>

#include <array>

namespace foam {
namespace {

// With the seed 5489, its default, the engine first returns 14514284786278117030,
// 4620546740167642908 and 13109570281517897720. The C++ standard fixes its 10000th number,
// 9981545732273789042. The mapping keeps the upper 53 bits of each number.
TEST(Random, MapsTheUpper53BitsOfTheEngine) {
    Random random(5489);
    EXPECT_EQ(random.uniform(), 0x192da3239eded5p-53);
    EXPECT_EQ(random.uniform(), 0x0803ef58f17901p-53);
    EXPECT_EQ(random.uniform(), 0x16bdd196d57c8ap-53);
    for (int k = 4; k < 10000; ++k) {
        random.uniform();
    }
    EXPECT_EQ(random.uniform(), 0x1150b25eb02fdbp-53);
}

TEST(Random, BelowScalesTheSameNumbers) {
    // The random numbers are 0.7868, 0.2505 and 0.7107, times ten.
    Random random(5489);
    EXPECT_EQ(random.below(10), 7U);
    EXPECT_EQ(random.below(10), 2U);
    EXPECT_EQ(random.below(10), 7U);
}

TEST(Random, StaysInItsRange) {
    Random random(1);
    for (int k = 0; k < 10000; ++k) {
        const double value = random.uniform();
        ASSERT_GE(value, 0.0);
        ASSERT_LT(value, 1.0);
    }
}

// Each of the 6 faces is expected 1000 times in 6000 throws, with a standard deviation of
// sqrt(6000 * 5/36) = 29.
TEST(Random, BelowReachesEveryValueAboutAsOften) {
    Random random(2);
    std::array<int, 6> count{};
    for (int k = 0; k < 6000; ++k) {
        ++count.at(random.below(6));
    }
    for (const int c : count) {
        EXPECT_NEAR(c, 1000, 5 * 29);
    }
}

}  // namespace
}  // namespace foam
