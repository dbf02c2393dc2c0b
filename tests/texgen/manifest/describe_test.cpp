// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/describe.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Describe, BakesOfDifferentMapsBelongTogether) {
    Preset preset;
    preset.name = std::string("a");  // an assignment of "a" itself warns in GCC 12 (bug 105651)
    const BakedSet set = describe(preset, {3, 1, 2});
    EXPECT_EQ(set.maps.front().frames, (std::vector{1, 2, 3}));
    EXPECT_EQ(set.preset, "a");
    Preset other = preset;
    other.image.maps = {"height"};
    EXPECT_EQ(describe(other, {1}).parameters, set.parameters);
    other.seeding.seed += 1;
    EXPECT_NE(describe(other, {1}).parameters, set.parameters);
}

TEST(Describe, ALoopHasAPeriod) {
    Preset preset;
    preset.loop.kind = LoopKind::None;
    EXPECT_EQ(describe(preset, {1}).loop.period, 0);
    preset.loop.kind = LoopKind::Breathe;
    preset.frames.count = 48;
    EXPECT_EQ(describe(preset, {1}).loop.period, 48);
    EXPECT_EQ(describe(preset, {1}).loop.kind, "breathe");
}

TEST(Describe, PathsAreRelativeToTheFolder) {
    EXPECT_EQ(relative_path("out/a/b.png", "out"), "a/b.png");
    EXPECT_EQ(relative_path("b.png", ""), "b.png");
}

}  // namespace
}  // namespace foam::texgen
