// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/drawn_variations.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "texgen/bake/bake.h"
#include "texgen/preset/load_preset.h"
#include "texgen/sheet/display_frame.h"
#include "texgen/variations/variation.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace foam::texgen {
namespace {

Preset small_preset() {
    Preset preset = load_preset("sea_foam");
    preset.seeding.bubbles = 12;
    preset.loop.kind = LoopKind::None;
    preset.frames.count = 2;
    preset.image.width = preset.image.height = 64;
    return preset;
}

TEST(DrawnVariations, HaveThePixelsOfABake) {
    const std::vector<Sweep> sweeps = {read_seeds("1-3")};
    const std::vector<Preset> presets = presets_of(small_preset(), variations_of(sweeps));
    const auto drawn = draw_variations(presets, {.frame = 2, .map = "lit", .side = 64});
    ASSERT_EQ(drawn.size(), 3U);
    EXPECT_NE(drawn[0].pixels, drawn[1].pixels);

    const TemporaryFolder folder;
    Preset preset = presets[2];
    preset.output.pattern = (folder.path() / "frame.png").string();
    bake(preset, {.frames = {2}});
    EXPECT_EQ(drawn[2].pixels, codes8(read_picture(folder.path() / "frame.png")));
}

TEST(DrawnVariations, DoNotDependOnTheNumberOfThreads) {
    const std::vector<Sweep> sweeps = {read_seeds("1-4")};
    const std::vector<Preset> presets = presets_of(small_preset(), variations_of(sweeps));
    const auto one = draw_variations(presets, {.map = "albedo", .side = 32, .threads = 1});
    const auto four = draw_variations(presets, {.map = "albedo", .side = 32, .threads = 4});
    for (std::size_t k = 0; k < presets.size(); ++k) {
        EXPECT_EQ(one[k].pixels.width(), 32);
        EXPECT_EQ(one[k].pixels, four[k].pixels) << k;
    }
}

TEST(DrawnVariations, AFoamWithoutEquilibriumIsGray) {
    std::vector<Preset> presets = {small_preset(), small_preset()};
    // One cycle is too few to close the loop.
    presets[1].loop = {.kind = LoopKind::Breathe, .amplitude = 0.9, .cycles = 1};
    presets[1].seeding.bubbles = 40;
    presets[1].frames.count = 6;
    const auto drawn = draw_variations(presets, {.map = "lit", .side = 32});
    EXPECT_EQ(drawn[0].outcome.status, RunStatus::Complete);
    EXPECT_NE(drawn[1].outcome.status, RunStatus::Complete);
    for (const std::uint8_t sample : drawn[1].pixels.samples()) {
        ASSERT_EQ(sample, kBackgroundGray);
    }
}

TEST(DrawnVariations, MustHaveTheSameShape) {
    std::vector<Preset> presets = {small_preset(), small_preset()};
    presets[1].image.width = 128;
    EXPECT_THROW(draw_variations(presets, {.map = "lit", .side = 64}), std::invalid_argument);
}

TEST(DrawnVariations, AMapOfWholeNumbersIsNoPicture) {
    const std::vector<Preset> presets = {small_preset()};
    EXPECT_THROW(draw_variations(presets, {.map = "id"}), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
