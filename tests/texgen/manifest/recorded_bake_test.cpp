// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/recorded_bake.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/simulation_counter.h"
#include "tests/texgen/small_preset.h"
#include "texgen/image/exr.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/png.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/set_choice.h"
#include "texgen/maps/all_maps.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr const char* kPattern = "{map}/{preset}.####.png";

BakedSet only_set(const std::filesystem::path& folder) {
    return newest_set(read_manifest(folder), {}, folder);
}

std::string hash_of_file(const std::filesystem::path& path) {
    return pixel_hash(read_picture(path));
}

// The manifest is in the folder that contains the folders of the maps.
TEST(RecordedBake, RecordsEveryFile) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    const auto names = map_names();
    preset.image.maps.assign(names.begin(), names.end());
    bake_recorded(preset, {.frames = {2, 1}, .threads = 2}, {});
    const BakedSet set = only_set(folder.path());
    EXPECT_TRUE(set.complete());
    EXPECT_EQ(set.frames(), (std::vector{1, 2}));
    EXPECT_EQ(set.toml, to_toml(preset));
    EXPECT_EQ(set.seed, 12U);
    ASSERT_EQ(set.files.size(), 2 * names.size());
    for (const ManifestFile& file : set.files) {
        const std::filesystem::path path = folder.path() / file.path;
        EXPECT_EQ(file.path,
                  file.maps.front() + "/small.000" + std::to_string(file.frame) + ".png");
        EXPECT_EQ(file.bytes, std::filesystem::file_size(path));
        EXPECT_EQ(file.pixels, hash_of_file(path)) << file.path;
    }
    EXPECT_EQ(set.files.front().maps.front(), names.front());
    EXPECT_EQ(set.files.front().frame, 1);
}

TEST(RecordedBake, DescribesSamples) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"albedo", "height", "motion", "id", "sides"};
    preset.maps.height.full = {0.75};
    preset.maps.motion.multiplier = {0.03};
    preset.maps.normal.y = NormalY::Down;
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const BakedSet set = only_set(folder.path());
    const auto samples = [&](const char* map) { return *set.find_map(map)->samples; };
    EXPECT_EQ(samples("albedo"), (MapSamples{"color", "R G B", "uint8", "sRGB", "none", {}}));
    EXPECT_EQ(samples("height").type, "uint16");
    EXPECT_EQ(samples("height").range, (std::array{0.0, preset.maps.height.full.value}));
    EXPECT_EQ(samples("motion").channels, "X Y 0");
    EXPECT_EQ(samples("id"), (MapSamples{"id", "Y", "uint16", "data", "none", {}}));
    EXPECT_EQ(set.conventions.normal_y, "down");
    EXPECT_EQ(set.conventions.motion_multiplier, preset.maps.motion.multiplier.value);
}

// The range does not depend on the frames that are baked. A later bake of a map with a range of its
// own completes the conventions. The frames that exist are kept.
TEST(RecordedBake, AutomaticRangesFitTheWholeAnimation) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"height", "albedo"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const auto range = *only_set(folder.path()).find_map("height")->samples->range;
    EXPECT_NE(range[1], preset.maps.height.full.value);
    const BakeSummary resumed =
        bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {}, {Resume::Yes});
    EXPECT_EQ(resumed.kept, 1);
    EXPECT_EQ(*only_set(folder.path()).find_map("height")->samples->range, range);
    preset.image.maps = {"motion"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const BakedSet set = only_set(folder.path());
    EXPECT_EQ(set.conventions.motion_multiplier, set.find_map("motion")->samples->range->at(1));
}

// The foam moves by 1/8 of the image width per frame. With the margin of 1 %, 0.16 is the next
// preferred number.
TEST(RecordedBake, AResumedBakeWithNothingToDoKeepsTheMotionMultiplier) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.frames.count = 8;
    preset.loop.kind = LoopKind::Drift;
    preset.loop.drift = {1, 0};
    preset.image.maps = {"motion"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const BakedSet before = only_set(folder.path());
    EXPECT_DOUBLE_EQ(before.conventions.motion_multiplier, 0.16);
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {}, {Resume::Yes});
    EXPECT_EQ(only_set(folder.path()), before);
}

// Ranges are fitted to all frames before the first one is drawn. Both use one simulation.
TEST(RecordedBake, SimulatesOnceForRangesAndImages) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"height"};
    SimulationCounter counter;
    bake_recorded(preset, {.frames = {2, 1}, .threads = 2}, {.on_progress = counter.callback()});
    EXPECT_EQ(counter.count(), 1);
}

// If a part of the animation is all that a source has, its ranges are recorded as numbers.
TEST(RecordedBake, RangesOfAPartOfTheAnimationMakeAnotherSet) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"height"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    bake_recorded(preset, {.frames = {2}, .threads = 1, .sequence = {1, 2}}, {});
    const Manifest manifest = read_manifest(folder.path());
    ASSERT_EQ(manifest.sets.size(), 2U);
    EXPECT_NE(manifest.sets[0].toml.find("full = \"auto\""), std::string::npos);
    EXPECT_EQ(manifest.sets[1].toml.find("[height]\nfull = \"auto\""), std::string::npos);
}

// A height range that is too small clips; an albedo has no range.
TEST(RecordedBake, RecordsClippedNumbers) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"albedo", "height"};
    preset.maps.height.full = {0.01};
    const BakeSummary summary = bake_recorded(preset, {.frames = {1, 2}, .threads = 2}, {});
    ASSERT_EQ(summary.numbers.size(), 1U);
    const BakedSet set = only_set(folder.path());
    EXPECT_EQ(set.find_file("albedo", 1)->numbers, std::nullopt);
    EXPECT_EQ(set.find_file("albedo", 1)->displacement, std::nullopt);
    for (const int frame : {1, 2}) {
        const ManifestFile& file = *set.find_file("height", frame);
        ASSERT_TRUE(file.numbers);
        EXPECT_GT(file.numbers->clipped, 0.5);
        EXPECT_GT(file.numbers->largest, 0.1);
        EXPECT_GT(file.displacement.value_or(0.0), 0.0);
    }
    EXPECT_EQ(summary.numbers.front().extent,
              joined(*set.find_file("height", 1)->numbers, *set.find_file("height", 2)->numbers));
}

// Only the channel height has a range; the channel that is inverted has the same extent as a map.
TEST(RecordedBake, RecordsTheClippedNumbersAndTheHeightsOfPackings) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"height"};
    preset.output.pack = {"P=height,roughness,0.5", "Q=roughness,metallic,0.5"};
    preset.maps.height.full = {0.25};
    const BakeSummary summary = bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    EXPECT_EQ(summary.numbers.size(), 2U);
    const BakedSet set = only_set(folder.path());
    const ManifestFile& height = *set.find_file("height", 1);
    const ManifestFile& packed = *set.find_file("P", 1);
    EXPECT_GT(packed.numbers.value().clipped, 0.0);
    EXPECT_EQ(packed.numbers->clipped, height.numbers.value().clipped);
    EXPECT_FLOAT_EQ(static_cast<float>(packed.numbers->largest),
                    static_cast<float>(height.numbers->largest / 0.25));
    EXPECT_EQ(packed.displacement, height.displacement);
    EXPECT_EQ(set.find_file("Q", 1)->numbers, std::nullopt);
    EXPECT_EQ(set.find_file("Q", 1)->displacement, std::nullopt);
}

// The number 1 in an EXR is a bubble diameter; the largest code of a PNG is height.full diameters.
TEST(RecordedBake, RecordsTheHeightOfTheNumberOneInAnExr) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "png" / kPattern);
    preset.image.maps = {"height"};
    preset.maps.height.full = {0.25};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    preset.output.pattern = (folder.path() / "exr" / "{map}.####.exr").string();
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const double png = only_set(folder.path() / "png").files.front().displacement.value();
    const double exr = only_set(folder.path() / "exr").files.front().displacement.value();
    EXPECT_DOUBLE_EQ(png, 0.25 * exr);
}

TEST(RecordedBake, RecordsThePixelFormatOfTextures) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "{map}.####.dds");
    preset.image.maps = {"albedo", "height"};
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const BakedSet set = only_set(folder.path());
    EXPECT_EQ(set.find_map("albedo")->samples->pixel_format, "BC7_UNORM_SRGB");
    EXPECT_EQ(set.find_map("height")->samples->pixel_format, "R16_UNORM");
}

TEST(RecordedBake, RecordsTheLayersOfAnExr) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.shape.kind = FoamKind::Patch;
    preset.image.maps = {"film", "albedo", "id"};
    preset.output.pattern = (folder.path() / "layers.####.exr").string();
    preset.output.exr_layout = ExrLayout::MipLevels;
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    const BakedSet set = only_set(folder.path());
    ASSERT_EQ(set.files.size(), 1U);
    EXPECT_EQ(set.files.front().maps, (std::vector<std::string>{"film", "albedo", "id"}));
    EXPECT_EQ(set.files.front().pixels, hash_of_file(folder.path() / "layers.0001.exr"));
    EXPECT_EQ(*set.find_map("albedo")->samples,
              (MapSamples{"color", "R G B A", "half", "linear sRGB", "premultiplied", {}}));
    EXPECT_EQ(set.find_map("film")->samples->type, "float");
    EXPECT_EQ(set.find_map("id")->samples->type, "uint32");
    EXPECT_FALSE(set.find_frame(1)->tiles);
}

TEST(RecordedBake, RecordsTheFoamAndTheLoop) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.frames.count = 6;
    preset.loop.kind = LoopKind::Breathe;
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    const BakedSet set = only_set(folder.path());
    EXPECT_EQ(set.loop.kind, "breathe");
    EXPECT_EQ(set.loop.period, 6);
    EXPECT_FALSE(set.loop.cross_faded);
    EXPECT_LT(set.loop.closing_error.value_or(1.0), 1e-9);
    ASSERT_NE(set.find_frame(2), nullptr);
    EXPECT_EQ(set.find_frame(2)->bubbles, 40);
    EXPECT_TRUE(set.find_frame(2)->tiles);
    EXPECT_NEAR(set.find_frame(2)->mean_area, 1.0, 1e-9);
    EXPECT_LT(set.find_frame(2)->area_error, 1e-9);
    EXPECT_GT(set.find_frame(2)->drawing, 0.0);
    ASSERT_TRUE(set.find_frame(2)->mechanics);
    const FrameMechanics& mechanics = *set.find_frame(2)->mechanics;
    EXPECT_GT(mechanics.energy, 0.0);
    EXPECT_EQ(mechanics.strain, 0.0);
    // The trace of the stress is the energy per area, and the mean area is 1.
    EXPECT_NEAR(40.0 * (mechanics.stress[0] + mechanics.stress[2]), mechanics.energy, 1e-8);
}

// Other maps and frames of the same foam are added to its set. Another seed makes another set.
TEST(RecordedBake, TheSameParametersAreOneSet) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    preset.image.maps = {"film"};
    bake_recorded(preset, {.frames = {2, 3}, .threads = 1}, {});
    EXPECT_EQ(only_set(folder.path()).files.size(), 4U);
    EXPECT_TRUE(only_set(folder.path()).complete());
    preset.seeding.seed = 13;
    bake_recorded(preset, {.frames = {2}, .threads = 1}, {});
    const Manifest manifest = read_manifest(folder.path());
    ASSERT_EQ(manifest.sets.size(), 2U);
    EXPECT_EQ(manifest.sets[0].files.size(), 3U);
    EXPECT_FALSE(manifest.sets[0].complete());
    EXPECT_TRUE(manifest.sets[1].complete());
}

TEST(RecordedBake, AFailedBakeRecordsTheFailureAndExistingFiles) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    const auto stop = [](const BakedFrame& baked) {
        if (baked.shown.frame->number == 2) {
            throw OutputError("no space left");
        }
    };
    EXPECT_THROW(bake_recorded(preset, {.frames = {1, 2, 3}, .threads = 1}, {.on_baked = stop}),
                 OutputError);
    const BakedSet set = only_set(folder.path());
    EXPECT_FALSE(set.complete());
    EXPECT_EQ(set.failure, "no space left");
    EXPECT_EQ(set.files.size(), 2U);
    EXPECT_EQ(set.frames(), (std::vector{1, 2, 3}));
}

TEST(RecordedBake, ARejectedBakeWritesNothing) {
    const TemporaryFolder folder;
    EXPECT_THROW(
        bake_recorded(small_preset(folder.path() / kPattern), {.frames = {}, .threads = 1}, {}),
        std::invalid_argument);
    Preset preset = small_preset(folder.path() / kPattern);
    preset.shape.kind = FoamKind::Patch;
    preset.shape.outline = "POLYGON((0 0, 1 0, 1 0.0000000001, 0 0.0000000001))";
    EXPECT_THROW(bake_recorded(preset, {.frames = {1}, .threads = 1}, {}), std::exception);
    EXPECT_TRUE(folder.files().empty());
}

}  // namespace
}  // namespace foam::texgen
