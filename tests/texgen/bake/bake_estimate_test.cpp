// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bake_estimate.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/frame_range.h"
#include "texgen/preset/load_preset.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace foam::texgen {
namespace {

std::uint64_t size_of(const std::vector<std::filesystem::path>& files) {
    std::uint64_t bytes = 0;
    for (const std::filesystem::path& path : files) {
        bytes += std::filesystem::file_size(path);
    }
    return bytes;
}

TEST(BakeEstimate, HasTheFilesOfABakeAndLeavesNone) {
    const TemporaryFolder folder;
    Preset preset = load_preset("sea_foam");
    preset.seeding.bubbles = 40;
    preset.loop.kind = LoopKind::None;
    preset.image.width = preset.image.height = 96;
    preset.image.maps = {"albedo", "normal", "height"};
    preset.output.pattern = (folder.path() / "{map}.##.png").string();
    const BakeOptions options{.frames = frames_to(6), .threads = 1};
    const BakeEstimate estimate = estimate_bake(preset, options, {});
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
    EXPECT_EQ(estimate.outcome.status, RunStatus::Complete);
    EXPECT_GT(estimate.seconds, 0.0);
    EXPECT_GT(estimate.memory, 1'000'000U);
    EXPECT_GT(estimate.simulating, 0.0);
    EXPECT_GT(estimate.drawing, 0.0);

    const BakeSummary baked = bake(preset, options);
    EXPECT_EQ(estimate.files, baked.files.size());
    const auto bytes = static_cast<double>(size_of(baked.files));
    EXPECT_LT(std::abs(static_cast<double>(estimate.bytes) / bytes - 1.0), 0.1);
}

// The pictures of a patch show the whole foam, so that the compressed pixels are alike at any size.
TEST(BakeEstimate, DrawsLargeImagesAtAReducedSize) {
    const TemporaryFolder folder;
    Preset preset = load_preset("soap_raft");
    preset.seeding.bubbles = 20;
    preset.image.maps = {"id"};
    preset.output.pattern = (folder.path() / "{map}.##.exr").string();
    preset.image.width = preset.image.height = 2 * kMaxEstimatedSide;
    const BakeOptions options{.frames = {1}, .threads = 1};
    const BakeEstimate estimate = estimate_bake(preset, options, {});
    EXPECT_EQ(estimate.outcome.status, RunStatus::Complete);
    const BakeSummary baked = bake(preset, options);
    EXPECT_EQ(estimate.files, baked.files.size());
    const auto bytes = static_cast<double>(size_of(baked.files));
    EXPECT_GT(static_cast<double>(estimate.bytes), bytes);
    EXPECT_LT(static_cast<double>(estimate.bytes), 4.0 * bytes);

    BakeOptions from_source = options;
    from_source.source = simulation_of(preset, 1);
    EXPECT_EQ(estimate_bake(preset, from_source, {}).bytes, estimate.bytes);
}

// All maps of a frame are layers of one file, so the two frames are exactly the estimated files.
TEST(BakeEstimate, CountsALayeredExrOnce) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "layers.####.exr");
    preset.image.maps = {"albedo", "film"};
    preset.output.texts =
        FileTexts::LeftOut;  // they contain the pattern, which the estimate changes
    const BakeOptions options{.frames = {1, 2}, .threads = 1};
    const BakeEstimate estimate = estimate_bake(preset, options, {});
    const BakeSummary baked = bake(preset, options);
    EXPECT_EQ(estimate.files, 2U);
    EXPECT_EQ(estimate.bytes, size_of(baked.files));
}

TEST(BakeEstimate, OfASingleFrameIsThatFrame) {
    const TemporaryFolder folder;
    Preset preset = load_preset("maze");
    preset.seeding.bubbles = 30;
    preset.output.pattern = (folder.path() / "maze.svg").string();
    const BakeEstimate estimate = estimate_bake(preset, {.frames = {1}}, {});
    EXPECT_EQ(estimate.files, 1U);
    bake(preset, {.frames = {1}});
    EXPECT_EQ(estimate.bytes, std::filesystem::file_size(folder.path() / "maze.svg"));
}

TEST(BakeEstimate, OfAFailedRunIsEmpty) {
    const TemporaryFolder folder;
    Preset preset = load_preset("sea_foam");
    preset.seeding.bubbles = 40;
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.9, .cycles = 1};
    preset.frames.count = 6;
    preset.output.pattern = (folder.path() / "####.png").string();
    const BakeEstimate estimate = estimate_bake(preset, {.frames = frames_to(6)}, {});
    EXPECT_EQ(estimate.outcome.status, RunStatus::OpenLoop);
    EXPECT_EQ(estimate.files, 0U);
}

}  // namespace
}  // namespace foam::texgen
