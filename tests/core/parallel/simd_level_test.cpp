// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/simd_level.h"

#include "tests/support/simd_levels.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>

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
    try {
        force_simd_level(SimdLevel::Avx512);
        FAIL();
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("SIMD level 'avx512' is not available on this machine; available: "
                               "baseline"),
                  0U)
            << message;
    }
}

TEST(SimdLevel, AnEmptyEnvironmentVariableCountsAsUnset) {
    const ForcedSimdLevel restores_the_level(simd_level());
    const char* const value = std::getenv("FOAMTEX_SIMD");
    const std::string before = value != nullptr ? value : "";
    setenv("FOAMTEX_SIMD", "", 1);
    EXPECT_EQ(detail::decide_simd_level(), available_simd_levels().back());
    setenv("FOAMTEX_SIMD", before.c_str(), 1);
}

// A fused multiply-add would round x² / 3 + x once; separate operations round it twice.
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
