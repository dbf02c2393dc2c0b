// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/camera_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(CameraOptions, LimitsHoldOnBothSides) {
    test::expect_limits(camera_keys(),
                        {{"zoom", "0.009", "0.01", "1000", "1001"},
                         {"center", "[-11, 0]", "[-10, 10]", "[10, 0.5]", "[0, 10.1]"},
                         {"margin", "-0.1", "0", "0.45", "0.46"}});
}

TEST(CameraOptions, AreForPatches) {
    for (const Key<CameraOptions>& key : camera_keys()) {
        ASSERT_TRUE(key.condition.has_value()) << key.path;
        EXPECT_EQ(key.condition->key, "foam.domain");
        EXPECT_EQ(key.condition->values, std::vector<std::string>{"patch"});
    }
}

}  // namespace
}  // namespace foam::texgen
