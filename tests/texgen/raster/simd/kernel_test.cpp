// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/simd/kernel.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Kernel, TakesTheSmallerAndTheLargerValue) {
    EXPECT_EQ(min_value(2.0, -3.0), -3.0);
    EXPECT_EQ(min_value(-3.0, 2.0), -3.0);
    EXPECT_EQ(max_value(2, -3), 2);
    EXPECT_EQ(max_value(-3, 2), 2);
}

TEST(Kernel, GrowsAnArrayAndNeverShrinksIt) {
    std::vector<int> values{7};
    grow(values, 10);
    EXPECT_GE(values.size(), 10U);
    EXPECT_EQ(values[0], 7);
    const std::size_t size = values.size();
    grow(values, 3);
    EXPECT_EQ(values.size(), size);
}

}  // namespace
}  // namespace foam::texgen
