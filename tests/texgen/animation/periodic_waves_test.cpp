// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/periodic_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace foam::texgen {
namespace {

// On a torus twice as wide as high, four waves along the height are eight along the width.
TEST(PeriodicWaves, HaveTheGivenWavelength) {
    const std::vector<PeriodicWave> waves =
        periodic_waves({.count = 20, .number = 4.0, .aspect = 2.0, .seed = 3});
    ASSERT_EQ(waves.size(), 20U);
    bool is_across = false;
    bool is_up = false;
    for (const PeriodicWave& wave : waves) {
        EXPECT_NEAR(std::hypot(0.5 * wave.across, wave.up), 4.0, 0.8);
        is_across = is_across || std::abs(wave.across) == 8;
        is_up = is_up || std::abs(wave.up) == 4;
    }
    EXPECT_TRUE(is_across && is_up);
}

TEST(PeriodicWaves, NoneIsConstant) {
    for (const double aspect : {0.25, 1.0, 4.0}) {
        const WaveOptions options{.count = 50, .number = 0.1, .aspect = aspect, .seed = 1};
        for (const PeriodicWave& wave : periodic_waves(options)) {
            EXPECT_TRUE(wave.across != 0 || wave.up != 0);
        }
    }
}

TEST(PeriodicWaves, DependOnTheSeed) {
    WaveOptions options{.count = 5, .number = 3.0, .variation = 0.5, .seed = 1};
    const std::vector<PeriodicWave> waves = periodic_waves(options);
    EXPECT_EQ(periodic_waves(options), waves);
    options.seed = 2;
    EXPECT_NE(periodic_waves(options), waves);
}

}  // namespace
}  // namespace foam::texgen
