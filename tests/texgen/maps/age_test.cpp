// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/age.h"

#include "tests/texgen/keys/limits.h"
#include "tests/texgen/maps/lone_circle.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::LoneCircle;

TEST(Age, IsSinceBirthOrChange) {
    LoneCircle circle(20.0);
    circle.frame.time = 10.0;
    circle.record.births.assign(8, 4.0);
    circle.record.changes.assign(8, 9.0);
    const auto at_middle = [&](const AgeOptions& options) {
        return draw_age(circle.layers, options).pixels.pixel(32, 32)[0];
    };
    EXPECT_NEAR(at_middle({}), 6.0, 1e-6);
    EXPECT_NEAR(at_middle({.since = AgeSince::Change}), 1.0, 1e-6);
    circle.record.changes[7] = 0.0;  // earlier than its birth
    EXPECT_NEAR(at_middle({.since = AgeSince::Change}), 6.0, 1e-6);
}

TEST(Age, LimitsHoldOnBothSides) {
    test::expect_limits(age_keys(), {{"full", "0", "1e-6", "1e9", "1e10"}});
}

TEST(Age, ChoicesHaveTheirWords) {
    test::expect_words(age_keys(), "since", {"birth", "change"});
}

}  // namespace
}  // namespace foam::texgen
