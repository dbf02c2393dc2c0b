// SPDX-License-Identifier: Apache-2.0

#include "core/library/require.h"

#include <foamtex/errors.h>
#include <gtest/gtest.h>

#include <limits>
#include <string>

namespace foam {
namespace {

template <class Check>
std::string fault_of(const Check& check) {
    try {
        check();
        return "none";
    } catch (const foamtex::ArgumentError& error) {
        return error.what();
    }
}

TEST(Require, GivesTheNameTheAllowedValuesAndTheValue) {
    EXPECT_EQ(fault_of([] { require(true, "center", "finite", "(0, inf)"); }), "none");
    EXPECT_EQ(fault_of([] { require(false, "center", "finite", "(0, inf)"); }),
              "center: must be finite, but is (0, inf)");
    EXPECT_EQ(fault_of([] { require(false, "kappa", "at least 0", -0.5); }),
              "kappa: must be at least 0, but is -0.5");
}

TEST(Require, BothEndsOfARangeAreAllowed) {
    EXPECT_EQ(fault_of([] { require_from("threads", 0, 0, 256); }), "none");
    EXPECT_EQ(fault_of([] { require_from("threads", 256, 0, 256); }), "none");
    EXPECT_EQ(fault_of([] { require_from("threads", 257, 0, 256); }),
              "threads: must be from 0 to 256, but is 257");
    EXPECT_EQ(
        fault_of([] { require_from("strain", std::numeric_limits<double>::quiet_NaN(), -1, 1); }),
        "strain: must be from -1 to 1, but is nan");
}

}  // namespace
}  // namespace foam
