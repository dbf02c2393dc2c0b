// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/max_or_nan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foam {
namespace {

TEST(MaxOrNan, IsTheLargerNumber) {
    EXPECT_EQ(max_or_nan(1.0, 2.0), 2.0);
    EXPECT_EQ(max_or_nan(2.0, 1.0), 2.0);
    EXPECT_EQ(max_or_nan(-1.0, -1.0), -1.0);
}

TEST(MaxOrNan, IsNanIfEitherNumberIs) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(std::isnan(max_or_nan(1.0, nan)));
    EXPECT_TRUE(std::isnan(max_or_nan(nan, 1.0)));
    EXPECT_TRUE(std::isnan(max_or_nan(nan, nan)));
}

}  // namespace
}  // namespace foam
