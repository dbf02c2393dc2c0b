// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/cache/small_simulation.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/packed_file.h"
#include "texgen/preset/simulation_keys.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns the contents of the files of a bake into a temporary folder. The files have no texts.
std::vector<Bytes> baked(Preset preset, const BakeOptions& options) {
    const TemporaryFolder folder;
    preset.output.pattern = (folder.path() / "{map}.####.png").string();
    preset.output.texts = FileTexts::LeftOut;
    std::vector<Bytes> contents;
    for (const std::filesystem::path& path : bake(preset, options, {}).files) {
        contents.push_back(read_file(path, kImageInput));
    }
    return contents;
}

/// Expects that the files of every frame are equal whether the frames are drawn from a cache, one
/// at a time, or baked together.
void expect_same_pixels(const Preset& preset, const std::vector<int>& frames) {
    const TemporaryFolder folder;
    const std::vector<Bytes> expected = baked(preset, {.frames = frames, .threads = 1});
    ASSERT_EQ(
        simulate_into_cache(preset, {.frames = frames, .threads = 1}, folder.path(), {}).status,
        RunStatus::Complete);
    const Cache cache(folder.path());
    EXPECT_EQ(cache.info().frames, frames);
    std::vector<Bytes> found;
    for (const int frame : frames) {
        const auto files = baked(preset,
                                 {.frames = {frame},
                                  .threads = 1,
                                  .source = cache.frames_of(preset, SkippedEfforts::Counted)});
        found.insert(found.end(), files.begin(), files.end());
    }
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const std::size_t maps = preset.image.maps.size();
        EXPECT_TRUE(found[k] == expected[k])
            << preset.image.maps[k % maps] << " of frame " << frames[k / maps];
    }
}

TEST(Cache, FramesOfACoarseningFoamAreThoseOfABake) {
    expect_same_pixels(all_maps_of_a_foam(), frames_to(4));
    expect_same_pixels(all_maps_of_a_foam(), {2, 5});
}

TEST(Cache, FramesOfALoopAreThoseOfABake) {
    Preset preset = all_maps_of_a_foam();
    preset.loop.kind = LoopKind::Breathe;
    preset.loop.drift = {1, 0};
    expect_same_pixels(preset, frames_to(6));
    preset.loop.kind = LoopKind::Shear;
    preset.loop.drift = {0, 0};
    expect_same_pixels(preset, {1, 6});
    preset.loop.kind = LoopKind::Drift;
    preset.loop.drift = {0, 1};
    expect_same_pixels(preset, {1, 6});
}

TEST(Cache, FramesOfAPingPongAreThoseOfABake) {
    Preset preset = all_maps_of_a_foam();
    preset.loop.kind = LoopKind::PingPong;
    expect_same_pixels(preset, frames_to(6));
    expect_same_pixels(preset, {5, 6});
}

// The last frames of the loop show two states each.
TEST(Cache, FramesOfAFlowAreThoseOfABake) {
    Preset preset = all_maps_of_a_foam();
    preset.loop = {.kind = LoopKind::Flow, .drift = {0, 1}, .fade = 0.5, .growth = 3};
    preset.frames.time_step = 2.0;
    expect_same_pixels(preset, frames_to(6));
    expect_same_pixels(preset, {2, 6, 9});
}

TEST(Cache, AFirstFrameOfTheDiagramIsThatOfABake) {
    Preset preset = all_maps_of_a_foam();
    preset.frames.first = FirstFrame::Diagram;
    expect_same_pixels(preset, {1, 2});
}

TEST(Cache, FramesOfAShearedFoamAreThoseOfABake) {
    Preset preset = all_maps_of_a_foam();
    Event event;
    event.kind = "shear";
    event.frames = {2, 4};
    event.shear.strain = 0.3;
    preset.events = {event};
    expect_same_pixels(preset, {1, 3, 4});
}

// Frame 1 determines the view, even if it is not drawn. The patch shrinks until no bubble is left.
TEST(Cache, FramesOfAPatchAreThoseOfABake) {
    Preset preset = all_maps_of_a_foam();
    preset.shape.kind = FoamKind::Patch;
    preset.seeding.bubbles = 12;
    preset.coarsening.kappa = 0.3;
    preset.camera.zoom = 1.5;
    expect_same_pixels(preset, {1, 2, 5, 12, 20, 24});
}

TEST(Cache, AnotherSizeAndOtherMapsAreThoseOfABakeOfThese) {
    const TemporaryFolder folder;
    Preset preset = all_maps_of_a_foam();
    simulate_into_cache(preset, {.frames = {1, 2}, .threads = 1}, folder.path(), {});
    preset.image.width = 96;
    preset.image.height = 64;
    preset.image.maps = {"normal"};
    preset.maps.normal.y = NormalY::Down;
    const Cache cache(folder.path());
    EXPECT_EQ(baked(preset,
                    {.frames = {2},
                     .threads = 2,
                     .source = cache.frames_of(preset, SkippedEfforts::Counted)}),
              baked(preset, {.frames = {2}, .threads = 2}));
}

// The files of two states are exchanged, so that all checksums hold.
TEST(Cache, AStateInThePlaceOfAnotherOneIsRejected) {
    const TemporaryFolder folder;
    const Preset preset = all_maps_of_a_foam();
    simulate_into_cache(preset, {.frames = {1, 2}, .threads = 1}, folder.path(), {});
    const auto path = [&](int number) { return state_path(folder.path(), number); };
    std::filesystem::copy_file(path(1), path(3), std::filesystem::copy_options::overwrite_existing);
    EXPECT_EQ(error_of(folder.path(), 2), "");
    EXPECT_EQ(error_of(folder.path(), 3),
              "cannot read '" + path(3).string() + "': the file contains state 1, not state 3");
}

// `render` may open a cache after `simulate` has written cache.json, but before it has written
// pressures.foam.
TEST(Cache, StatesAddedAfterOpeningCanBeRead) {
    const TemporaryFolder complete;
    const TemporaryFolder growing;
    simulate_into_cache(all_maps_of_a_foam(), {.frames = {1}, .threads = 1}, complete.path(), {});
    std::filesystem::copy_file(complete.path() / kCacheName, growing.path() / kCacheName);
    const Cache cache(growing.path());
    for (const std::filesystem::path& path :
         {pressures_path(complete.path()), state_path(complete.path(), 1)}) {
        std::filesystem::copy_file(path, growing.path() / path.filename());
    }
    const SimulatedFrame expected = Cache(complete.path()).state(1);
    EXPECT_FALSE(expected.record->first_pressures.empty());
    EXPECT_EQ(cache.state(1).record->first_pressures, expected.record->first_pressures);
}

TEST(Cache, DamagedPressuresAreAnInputError) {
    const TemporaryFolder folder;
    const Preset preset = all_maps_of_a_foam();
    simulate_into_cache(preset, {.frames = {1}, .threads = 1}, folder.path(), {});
    const std::filesystem::path path = pressures_path(folder.path());
    write_packed(path, {"scale", simulation_hash(preset)}, Bytes(3));
    EXPECT_EQ(error_of(folder.path(), 1),
              "cannot read '" + path.string() + "': unexpected end of the file");
}

}  // namespace
}  // namespace foam::texgen
