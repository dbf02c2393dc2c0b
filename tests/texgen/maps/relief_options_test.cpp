// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(ReliefOptions, LimitsHoldOnBothSides) {
    test::expect_limits(relief_keys(),
                        {{"angle", "0.9", "1", "85", "86"},
                         {"width", "0", "0.001", "10", "11"},
                         {"strength", "-1", "0", "100", "101"}});
}

TEST(ReliefOptions, ChoicesHaveTheirWords) {
    test::expect_words(relief_keys(), "profile", {"dome", "ridge", "wet"});
    test::expect_words(relief_keys(), "films", {"all", "walls"});
    test::expect_words(relief_keys(), "mean_bubble", {"seed", "current"});
}

}  // namespace
}  // namespace foam::texgen
