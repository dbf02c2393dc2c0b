// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/shared_simulation.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/simulation_keys.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Preset coarsening(const TemporaryFolder& folder, int side) {
    Preset preset = small_preset((folder.path() / "{size}_{map}.##.png").string());
    preset.coarsening.kappa = 0.05;
    preset.image.width = preset.image.height = side;
    preset.image.maps = {"albedo", "motion"};
    preset.frames.count = 3;
    return preset;
}

std::vector<std::string> hashes_of(const BakeSummary& summary) {
    std::vector<std::string> hashes;
    for (const std::filesystem::path& path : summary.files) {
        hashes.push_back(pixel_hash(read_picture(path)));
    }
    return hashes;
}

// The map `motion` also needs the state after each frame.
TEST(SharedSimulation, GivesEachBakeTheFramesOfASimulationOfItsOwn) {
    const TemporaryFolder folder;
    const Preset large = coarsening(folder, 48);
    const Preset small = coarsening(folder, 24);
    ASSERT_EQ(simulation_hash(large), simulation_hash(small));
    SharedSimulation shared(large, frames_to(3), 1);
    int simulations = 0;
    Phase last = Phase::Frames;
    const auto count = [&](const RunProgress& progress) {
        simulations += progress.phase == Phase::Equilibrium && last != Phase::Equilibrium ? 1 : 0;
        last = progress.phase;
    };
    for (const Preset* const preset : {&large, &small}) {
        const std::vector<std::string> own =
            hashes_of(bake(*preset, {.frames = frames_to(3), .threads = 1}));
        const BakeSummary summary =
            bake(*preset,
                 {.frames = frames_to(3), .threads = 1, .source = shared.source(*preset)},
                 {.on_progress = count});
        EXPECT_EQ(summary.outcome.status, RunStatus::Complete);
        EXPECT_EQ(hashes_of(summary), own);
        EXPECT_EQ(own.size(), 6U);
    }
    EXPECT_EQ(simulations, 1);
}

TEST(SharedSimulation, OfAFoamThatFailsGivesNoFrame) {
    const TemporaryFolder folder;
    Preset preset = coarsening(folder, 16);
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.9, .cycles = 1};
    preset.frames.count = 6;
    SharedSimulation shared(preset, {1}, 1);
    for (int time = 0; time < 2; ++time) {
        int frames = 0;
        const RunOutcome outcome = shared.source(preset)(
            {1}, NextFrames::Omitted, [&](const SimulatedFrame&) { ++frames; }, {});
        EXPECT_EQ(outcome.status, RunStatus::OpenLoop);
        EXPECT_EQ(frames, 0);
    }
}

TEST(FramesToSimulate, AreTheWholeAnimationIfARangeIsAutomatic) {
    const TemporaryFolder folder;
    Preset colors = coarsening(folder, 16);
    colors.image.maps = {"albedo"};
    EXPECT_EQ(frames_to_simulate({colors}, {3, 1}), (std::vector<int>{1, 3}));
    Preset heights = coarsening(folder, 8);
    heights.image.maps = {"height"};
    ASSERT_TRUE(heights.maps.height.full.is_automatic);
    EXPECT_EQ(frames_to_simulate({colors, heights}, {5}), (std::vector<int>{1, 2, 3, 5}));
}

}  // namespace
}  // namespace foam::texgen
