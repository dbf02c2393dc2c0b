// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/image/png.h"
#include "texgen/manifest/manifest_file.h"
#include "texgen/manifest/recorded_bake.h"
#include "texgen/manifest/set_choice.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns a preset of two maps. One of them, age, needs the history of bubbles.
Preset two_maps(const std::filesystem::path& folder) {
    Preset preset = small_preset(folder / "{map}.####.png");
    preset.image.maps = {"albedo", "age"};
    return preset;
}

/// Bakes with Resume::Yes. Returns the numbers of the frames that are drawn.
std::set<int> resumed(const Preset& preset, const std::vector<int>& frames) {
    std::set<int> drawn;
    const BakeSummary summary = bake_recorded(
        preset,
        {.frames = frames, .threads = 1},
        {.on_baked = [&](const BakedFrame& b) { drawn.insert(b.shown.frame->number); }},
        {Resume::Yes});
    EXPECT_EQ(static_cast<std::size_t>(summary.kept) + drawn.size(), frames.size());
    EXPECT_EQ(summary.files.size(), frames.size() * preset.image.maps.size());
    return drawn;
}

/// Bakes until the files of frame `last` are written, and then fails.
void bake_until(const Preset& preset, const std::vector<int>& frames, int last) {
    const auto stop = [&](const BakedFrame& baked) {
        if (baked.shown.frame->number == last) {
            throw OutputError("no space left");
        }
    };
    EXPECT_THROW(bake_recorded(preset, {.frames = frames, .threads = 1}, {.on_baked = stop}),
                 OutputError);
}

std::map<std::string, Bytes> images_of(const TemporaryFolder& folder) {
    std::map<std::string, Bytes> images;
    for (const std::string& name : folder.files()) {
        if (name.ends_with(".png")) {
            images[name] = read_file(folder.path() / name, kImageInput);
        }
    }
    return images;
}

/// Returns the only set of a manifest, with all times set to 0.
BakedSet timeless_set(const std::filesystem::path& folder) {
    BakedSet set = newest_set(read_manifest(folder), {}, folder);
    for (FrameStatistics& frame : set.frame_statistics) {
        frame.simulating = frame.drawing = 0.0;
    }
    return set;
}

TEST(Resume, GivesTheSameBytesAsABakeThatWasNotInterrupted) {
    const std::vector<int> frames{1, 2, 3, 4, 5};
    const TemporaryFolder whole;
    Preset preset = two_maps(whole.path());
    preset.output.texts = FileTexts::LeftOut;
    bake_recorded(preset, {.frames = frames, .threads = 1}, {});
    const TemporaryFolder parts;
    Preset same = preset;
    same.output.pattern = two_maps(parts.path()).output.pattern;
    bake_until(same, frames, 3);
    EXPECT_EQ(resumed(same, frames), (std::set{4, 5}));
    EXPECT_EQ(images_of(parts), images_of(whole));
    BakedSet found = timeless_set(parts.path());
    const BakedSet expected = timeless_set(whole.path());
    EXPECT_TRUE(found.complete());
    EXPECT_EQ(found.files, expected.files);
    EXPECT_EQ(found.frame_statistics, expected.frame_statistics);
    EXPECT_EQ(found.failure, "");
}

TEST(Resume, DoesNothingIfAllFilesExist) {
    const TemporaryFolder folder;
    Preset preset = two_maps(folder.path());
    preset.loop.kind = LoopKind::Drift;
    preset.loop.drift = {1, 0};
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    const BakedSet before = newest_set(read_manifest(folder.path()), {}, "");
    EXPECT_TRUE(resumed(preset, {1, 2}).empty());
    EXPECT_EQ(newest_set(read_manifest(folder.path()), {}, ""), before);
    EXPECT_EQ(resumed(preset, {1, 2, 3}), (std::set{3}));
}

// Existing files are replaced if they were baked with other parameters.
TEST(Resume, RebakesFilesOfOtherParameters) {
    const TemporaryFolder folder;
    Preset preset = two_maps(folder.path());
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    preset.seeding.seed = 13;
    EXPECT_EQ(resumed(preset, {1, 2}), (std::set{1, 2}));
    EXPECT_TRUE(resumed(preset, {1, 2}).empty());
    preset.image.maps = {"albedo", "film"};
    EXPECT_EQ(resumed(preset, {1, 2}), (std::set{1, 2}));
}

TEST(Resume, RebakesMissingDamagedOrChangedFiles) {
    const TemporaryFolder folder;
    const Preset preset = two_maps(folder.path());
    const std::vector<int> frames{1, 2, 3, 4};
    bake_recorded(preset, {.frames = frames, .threads = 1}, {});
    const auto images = images_of(folder);
    std::filesystem::remove(folder.path() / "age.0001.png");
    Bytes damaged = images.at("albedo.0002.png");
    damaged[damaged.size() / 2] ^= std::byte{1};
    write_file(folder.path() / "albedo.0002.png", damaged);
    write_file(folder.path() / "albedo.0004.png", images.at("albedo.0003.png"));
    EXPECT_EQ(resumed(preset, frames), (std::set{1, 2, 4}));
    EXPECT_EQ(images_of(folder), images);
}

// A layered EXR of two maps is not what a bake of one of them writes.
TEST(Resume, RebakesLayeredFilesOfMoreMaps) {
    const TemporaryFolder folder;
    Preset preset = two_maps(folder.path());
    preset.output.pattern = (folder.path() / "layers.####.exr").string();
    bake_recorded(preset, {.frames = {1, 2}, .threads = 1}, {});
    preset.image.maps = {"age"};
    EXPECT_EQ(resumed(preset, {1, 2}), (std::set{1, 2}));
    EXPECT_TRUE(resumed(preset, {1, 2}).empty());
}

TEST(Resume, BakesEverythingWithoutAManifest) {
    const TemporaryFolder folder;
    const Preset preset = two_maps(folder.path());
    bake_recorded(preset, {.frames = {1}, .threads = 1}, {});
    std::filesystem::remove(folder.path() / kManifestName);
    EXPECT_EQ(resumed(preset, {1}), (std::set{1}));
}

}  // namespace
}  // namespace foam::texgen
