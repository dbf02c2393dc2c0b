// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/identity_number.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace foam::texgen {
namespace {

// The number is the fractional part of (identity + 1) times 0.7548776662466927 or
// 0.5698402909980532.
TEST(IdentityNumber, IsAFractionalPart) {
    EXPECT_DOUBLE_EQ(identity_number(0, IdentityStream::First), 0.7548776662466927);
    EXPECT_NEAR(identity_number(1, IdentityStream::First), 0.5097553324933854, 1e-15);
    EXPECT_NEAR(identity_number(3, IdentityStream::Second), 0.2793611639922128, 1e-15);
}

// Each tenth of the range contains 100 of 1,000 numbers, give or take 3.
TEST(IdentityNumber, IsSpreadEvenly) {
    for (const auto stream : {IdentityStream::First, IdentityStream::Second}) {
        std::array<int, 10> counts{};
        for (BubbleIdentity identity = 0; identity < 1000; ++identity) {
            ++counts.at(static_cast<std::size_t>(10.0 * identity_number(identity, stream)));
        }
        for (const int count : counts) {
            EXPECT_NEAR(count, 100, 3);
        }
    }
}

}  // namespace
}  // namespace foam::texgen
