// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_remarks.h"

#include <gtest/gtest.h>

#include <memory>

namespace foam::texgen {
namespace {

TEST(PresetRemarks, TheDensityIsStretchedOverTheTorusOrTheOutline) {
    Preset preset;
    preset.image.width = 300;
    preset.image.height = 100;
    EXPECT_TRUE(density_domain(preset).is_torus);
    EXPECT_DOUBLE_EQ(density_domain(preset).aspect, 3.0);
    preset.shape.kind = FoamKind::Patch;
    preset.shape.outline = "rectangle";
    preset.shape.outline_aspect = 2.0;
    EXPECT_FALSE(density_domain(preset).is_torus);
    EXPECT_DOUBLE_EQ(density_domain(preset).aspect, 2.0);
}

TEST(PresetRemarks, AreOnKeysWithoutEffectAndOnThePicture) {
    Preset preset;
    EXPECT_TRUE(remarks_on(preset, {}).empty());
    preset.image.width = 2 * preset.image.height;
    preset.density.source = {
        "x.png", {"x.png", std::make_shared<const SourcePicture>(SourcePicture{{1, 1, 4}}), ""}};
    EXPECT_EQ(remarks_on(preset, {}).size(), 1U);
}

}  // namespace
}  // namespace foam::texgen
