// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/simd_level.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace foam {
namespace {

TEST(SimdLevel, TheLowestIsAlwaysAvailable) {
    const std::vector<SimdLevel> levels = available_simd_levels();
    ASSERT_FALSE(levels.empty());
    EXPECT_EQ(levels.front(), SimdLevel::Baseline);
    EXPECT_EQ(name_of(SimdLevel::Baseline), "baseline");
}

TEST(SimdLevel, IsForcedForAScope) {
    const SimdLevel before = simd_level();
    at_every_simd_level([] {
        const SimdLevel forced = simd_level();
        at_simd_level([forced](auto level) {
            if constexpr (level() != SimdLevel::Baseline) {
                EXPECT_EQ(level(), forced);
            }
        });
    });
    EXPECT_EQ(simd_level(), before);
}

TEST(SimdLevel, RejectsALevelThatTheMachineLacks) {
    if (available_simd_levels().back() == SimdLevel::Avx512) {
        GTEST_SKIP() << "this machine has all levels";
    }
    EXPECT_THROW(force_simd_level(SimdLevel::Avx512), std::invalid_argument);
}

// x² / 3 + x with a fused multiply-add would round once where this rounds twice.
TEST(SimdLevel, HasTheSameBitsOnEachLevel) {
    using Numbers = std::array<double, 64>;
    Numbers baseline{};
    const auto compute = [](Numbers& to) {
        at_simd_level([&to] {
            for (std::size_t k = 0; k < to.size(); ++k) {
                const double x = static_cast<double>(k) * 0.1;
                to[k] = std::sqrt(x * x / 3.0 + x);
            }
        });
    };
    {
        const ForcedSimdLevel forced(SimdLevel::Baseline);
        compute(baseline);
    }
    at_every_simd_level([&] {
        Numbers numbers{};
        compute(numbers);
        EXPECT_EQ(numbers, baseline);
    });
}

}  // namespace
}  // namespace foam
