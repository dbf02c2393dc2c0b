// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/loop.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Loop, LimitsHoldOnBothSides) {
    test::expect_limits(loop_keys(),
                        {{"amplitude", "-0.1", "0", "0.9", "1"},
                         {"boiling", "0.0009", "0.001", "0.5", "0.51"},
                         {"drift", "[-101, 0]", "[-100, 100]", "[100, -1]", "[0, 101]"},
                         {"current", "-0.1", "0", "0.6", "0.61"},
                         {"eddies", "0", "1", "16", "17"},
                         {"cycles", "0", "1", "1000", "1001"},
                         {"fade", "0.009", "0.01", "1", "1.1"},
                         {"fade_spread", "-0.1", "0", "0.95", "0.96"},
                         {"growth", "0", "1", "1000", "1001"}});
    test::expect_words(
        loop_keys(), "kind", {"none", "breathe", "shear", "boil", "drift", "flow", "pingpong"});
}

// In breathe, shear and boil the foam repeats its motion, in drift it is displaced around the
// torus, and a flow is closed by a cross-fade.
TEST(Loop, ClosesByItselfOrByAFade) {
    const auto loop = [](LoopKind kind) { return LoopOptions{.kind = kind}; };
    for (const LoopKind kind : {LoopKind::Breathe, LoopKind::Shear, LoopKind::Boil}) {
        EXPECT_TRUE(loop(kind).is_cycle());
        EXPECT_TRUE(loop(kind).returns_to_start());
    }
    EXPECT_FALSE(loop(LoopKind::Drift).is_cycle());
    EXPECT_TRUE(loop(LoopKind::Drift).returns_to_start());
    EXPECT_TRUE(loop(LoopKind::Flow).is_cross_faded());
    EXPECT_FALSE(loop(LoopKind::Flow).returns_to_start());
    for (const LoopKind kind : {LoopKind::None, LoopKind::PingPong}) {
        EXPECT_FALSE(loop(kind).returns_to_start());
        EXPECT_FALSE(loop(kind).is_cross_faded());
    }
}

}  // namespace
}  // namespace foam::texgen
