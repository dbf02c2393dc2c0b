// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/texgen/cache/small_simulation.h"
#include "texgen/cache/cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace foam::texgen {
namespace {

// States that an earlier simulation left in the folder must not be used.
TEST(SimulateIntoCache, DoesNotReuseStatesOfAnotherSimulation) {
    const TemporaryFolder folder;
    Preset preset = all_maps_of_a_foam();
    simulate_into_cache(preset, {.frames = {1, 2, 3, 4}, .threads = 1}, folder.path(), {});
    preset.seeding.seed = 13;
    simulate_into_cache(preset, {.frames = {1}, .threads = 1}, folder.path(), {});
    EXPECT_EQ(error_of(folder.path(), 2), "");  // the state after frame 1
    EXPECT_NE(error_of(folder.path(), 4).find("different simulation"), std::string::npos);
}

TEST(SimulateIntoCache, ARejectedSimulationWritesNothing) {
    const TemporaryFolder folder;
    const std::filesystem::path deep = folder.path() / "deep";
    EXPECT_THROW(simulate_into_cache(all_maps_of_a_foam(), {.frames = {}, .threads = 1}, deep, {}),
                 std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(deep));
}

TEST(SimulateIntoCache, TheEstimatedSizeIsRightWithinAFactorOfTwo) {
    const TemporaryFolder folder;
    Preset preset = all_maps_of_a_foam();
    preset.seeding.bubbles = 200;
    const auto estimated =
        static_cast<double>(estimated_cache_size(preset, {1, 2, 3}, folder.path()));
    simulate_into_cache(preset, {.frames = {1, 2, 3}, .threads = 1}, folder.path(), {});
    double written = 0.0;
    for (const std::string& name : folder.files()) {
        written += static_cast<double>(std::filesystem::file_size(folder.path() / name));
    }
    EXPECT_GT(estimated, 0.5 * written);
    EXPECT_LT(estimated, 2.0 * written);
    EXPECT_EQ(estimated_cache_size(preset, {1, 2, 3}, folder.path()), 0U);  // all states exist
}

}  // namespace
}  // namespace foam::texgen
