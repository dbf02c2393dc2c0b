// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/table_lookup.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace foam::texgen {
namespace {

TEST(TableLookup, InterpolatesAndEndsAtTheLastEntry) {
    constexpr std::array kTable = {1.0, 3.0, -1.0};
    const auto at = [&](double position) { return looked_up(kTable.data(), 2, position); };
    EXPECT_EQ(at(0.0), 1.0);
    EXPECT_EQ(at(0.25), 1.5);
    EXPECT_EQ(at(1.0), 3.0);
    EXPECT_EQ(at(1.5), 1.0);
    EXPECT_EQ(at(2.0), -1.0);
    EXPECT_EQ(at(7.0), -1.0);
    EXPECT_EQ(at(std::numeric_limits<double>::infinity()), -1.0);
}

}  // namespace
}  // namespace foam::texgen
