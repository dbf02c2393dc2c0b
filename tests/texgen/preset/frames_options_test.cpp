// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/frames_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(FramesOptions, LimitsHoldOnBothSides) {
    test::expect_limits(frames_keys(),
                        {{"count", "0", "1", "100000", "100001"},
                         {"time_step", "-1", "0", "1e6", "1000001"},
                         {"step_growth", "0.09", "0.1", "10", "10.1"},
                         {"warm_up", "-1", "0", "1e6", "1000001"},
                         {"smoothing", "-1", "0", "1000", "1001"}});
    test::expect_words(frames_keys(), "first", {"equilibrium", "diagram"});
}

}  // namespace
}  // namespace foam::texgen
