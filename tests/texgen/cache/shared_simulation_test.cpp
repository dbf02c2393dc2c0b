// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/shared_simulation.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/simulation_counter.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/preset/simulation_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
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

// As long as this object exists, nothing can be created in the folder for temporary files: it is
// /proc, which not even root can write.
class NoTemporaryFolder {
  public:
    NoTemporaryFolder() : before_(getenv("TMPDIR") == nullptr ? "" : getenv("TMPDIR")) {
        setenv("TMPDIR", "/proc", 1);
    }

    ~NoTemporaryFolder() {
        if (before_.empty()) {
            unsetenv("TMPDIR");
        } else {
            setenv("TMPDIR", before_.c_str(), 1);
        }
    }

    NoTemporaryFolder(const NoTemporaryFolder&) = delete;
    NoTemporaryFolder& operator=(const NoTemporaryFolder&) = delete;

  private:
    std::string before_;
};

// Bakes in two sizes from one shared simulation. Returns the number of simulations.
int simulations_of_two_sizes(const Preset& large, const Preset& small) {
    SharedSimulation shared(large, frames_to(3), 1);
    SimulationCounter counter;
    for (const Preset* const preset : {&large, &small}) {
        const std::vector<std::string> own =
            hashes_of(bake(*preset, {.frames = frames_to(3), .threads = 1}));
        const BakeSummary summary =
            bake(*preset,
                 {.frames = frames_to(3), .threads = 1, .source = shared.source(*preset)},
                 {.on_progress = counter.callback()});
        EXPECT_EQ(summary.outcome.status, RunStatus::Complete);
        EXPECT_EQ(hashes_of(summary), own);
        EXPECT_EQ(own.size(), 6U);
    }
    return counter.count();
}

// The map `motion` also needs the state after each frame.
TEST(SharedSimulation, GivesEachBakeTheFramesOfASimulationOfItsOwn) {
    const TemporaryFolder folder;
    const Preset large = coarsening(folder, 48);
    const Preset small = coarsening(folder, 24);
    ASSERT_EQ(simulation_hash(large), simulation_hash(small));
    EXPECT_EQ(simulations_of_two_sizes(large, small), 1);
}

TEST(SharedSimulation, SimulatesAgainIfStatesCannotBeStored) {
    const TemporaryFolder folder;
    const NoTemporaryFolder missing;
    EXPECT_EQ(simulations_of_two_sizes(coarsening(folder, 48), coarsening(folder, 24)), 2);
}

// A pass over some of the frames reports the effort of the states between them, too.
TEST(SharedSimulation, GivesTheEffortSinceTheFrameBefore) {
    const TemporaryFolder folder;
    Preset preset = coarsening(folder, 16);
    preset.coarsening.kappa = 0.5;
    preset.frames.count = 4;
    const auto efforts = [](const FrameSource& source) {
        std::vector<FrameEffort> all;
        source({2, 4},
               NextFrames::Omitted,
               [&](const SimulatedFrame& shown) { all.push_back(shown.effort); },
               {});
        return all;
    };
    const std::vector<FrameEffort> own = efforts(simulation_of(preset, 1));
    SharedSimulation shared(preset, frames_to(4), 1);
    for (const char* const pass : {"simulated", "stored"}) {
        const std::vector<FrameEffort> given = efforts(shared.source(preset));
        ASSERT_EQ(given.size(), own.size());
        for (std::size_t k = 0; k < own.size(); ++k) {
            EXPECT_EQ(given[k].t1, own[k].t1) << pass;
            EXPECT_EQ(given[k].t2, own[k].t2) << pass;
            EXPECT_EQ(given[k].events.size(), own[k].events.size()) << pass;
        }
    }
    EXPECT_GT(own[1].events.size(), 0U);
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
