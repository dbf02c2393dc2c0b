// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/bake_plan.h"

#include "core/files/scratch_folder.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <optional>
#include <string>

namespace foam::texgen {
namespace {

// The preset has events of its own, which the event of the page replaces.
TEST(BakePlan, HasTheEventsOfThePageOnce) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    const std::string events = "[[event]]\nkind = \"collapse\"\nframe = 2\nsides = 5\n";
    for (const std::optional<std::string>& profile :
         {std::optional<std::string>(), std::optional<std::string>("unreal")}) {
        const BakePlan plan =
            plan_of({.settings = {.preset = "collapse", .set = {}, .events = events},
                     .folder = "out",
                     .profile = profile},
                    folder);
        ASSERT_EQ(plan.preset.events.size(), 1U);
        EXPECT_EQ(plan.preset.events.front().frames.first, 2);
        EXPECT_EQ(plan.command, "");
    }
}

// The working folder of the tests has no such picture.
TEST(BakePlan, ReadsPicturesBelowTheFolder) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    write_png(scratch.path() / "only_in_the_studio.png", Image<std::uint8_t>(1, 1, 1).view());
    BakeRequest request{
        .settings = {.preset = "sea_foam", .set = {"foam.density=only_in_the_studio.png"}},
        .folder = "out"};
    EXPECT_TRUE(plan_of(request, folder).preset.density.source.picture.is_set());
    request.profile = "unreal";
    const BakePlan plan = plan_of(request, folder);
    EXPECT_TRUE(plan.preset.density.source.picture.is_set());
    EXPECT_NE(plan.command.find("foam.density=only_in_the_studio.png"), std::string::npos);
}

TEST(BakePlan, ThePageOverridesTheProfile) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    const BakePlan plan = plan_of({.settings = {.preset = "lava", .set = {"normal.y=gl"}},
                                   .folder = "out",
                                   .profile = "unreal"},
                                  folder);
    EXPECT_EQ(plan.preset.maps.normal.y, NormalY::Up);
    EXPECT_FALSE(plan.preset.output.pack.empty());
}

}  // namespace
}  // namespace foam::texgen
