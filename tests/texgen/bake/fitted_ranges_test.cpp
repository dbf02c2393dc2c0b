// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/fitted_ranges.h"

#include "texgen/maps/all_maps.h"
#include "texgen/maps/number_extent.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

Preset small_preset(const std::string& map) {
    Preset preset;
    preset.seeding.bubbles = 40;
    preset.frames.count = 5;
    preset.frames.time_step = 2.0;
    preset.image.width = preset.image.height = 600;
    preset.image.maps = {map};
    return preset;
}

void fit(Preset& preset) {
    const RunOutcome outcome =
        fit_automatic_ranges(preset, simulation_of(preset, 1), {1, 2, 3, 4, 5}, 1);
    ASSERT_EQ(outcome.status, RunStatus::Complete);
}

// Returns the numbers in the full images of all frames of a preset with one map.
NumberExtent extent_of_all_frames(const Preset& preset) {
    const Map& map = find_map(preset.image.maps.front());
    NumberExtent extent;
    simulate_frames(
        preset, 1, {1, 2, 3, 4, 5}, NextFrames::Included, [&](const SimulatedFrame& shown) {
            FrameLayers layers({*shown.frame,
                                *shown.record,
                                shown.next.get(),
                                distance_needs(preset.image.maps, preset.maps)},
                               {preset.image.width, preset.image.height, 0, 0, shown.view},
                               1);
            extent =
                joined(extent, extent_of(std::get<NumberPixels>(map.draw(layers, preset.maps))));
        });
    return extent;
}

TEST(FittedRanges, RoundsUpToPreferredNumbers) {
    EXPECT_EQ(rounded_up(1.0), 1.0);
    EXPECT_EQ(rounded_up(1.01), 1.25);
    EXPECT_EQ(rounded_up(0.0301), 0.0315);
    EXPECT_EQ(rounded_up(9.0), 10.0);
    EXPECT_EQ(rounded_up(640.0), 800.0);
    for (double number = 1e-7; number < 1e7; number *= 1.07) {
        const double rounded = rounded_up(number);
        EXPECT_GE(rounded, number);
        EXPECT_LE(rounded, 1.281 * number);
    }
}

// No gas diffuses, so the growth of this foam consists of rounding errors at most.
TEST(FittedRanges, RoundingErrorsDoNotChangeARange) {
    Preset preset = small_preset("growth");
    preset.loop.kind = LoopKind::None;
    preset.coarsening.kappa = 0.0;
    const double range = preset.maps.growth.full.value;
    fit(preset);
    EXPECT_EQ(preset.maps.growth.full.value, range);
    const NumberExtent extent = extent_of_all_frames(preset);
    EXPECT_LT(std::max(-extent.smallest, extent.largest), 1e-9);
}

TEST(FittedRanges, EveryMapFitsItsNumbersWithAtMost30PercentToSpare) {
    for (const char* map : {"height", "distance", "area", "growth", "age", "motion", "curvature"}) {
        Preset preset = small_preset(map);
        ASSERT_TRUE(has_automatic_ranges(preset)) << map;
        range_option_of(find_map(map), preset.maps)->value = 50.0;  // far too large or too small
        fit(preset);
        const AutoReal full = *range_option_of(find_map(map), preset.maps);
        const NumberExtent extent = extent_of_all_frames(preset);
        const double largest = std::max(-extent.smallest, extent.largest);
        EXPECT_TRUE(full.is_automatic) << map;
        EXPECT_EQ(extent.clipped, 0.0) << map;
        EXPECT_LE(full.value, 1.3 * largest) << map;
    }
}

TEST(FittedRanges, DistancesInPixelsFitTheFullImage) {
    Preset preset = small_preset("distance");
    preset.maps.distance.unit = DistanceUnit::Pixels;
    preset.image.width = preset.image.height = 1200;
    fit(preset);
    const NumberExtent extent = extent_of_all_frames(preset);
    EXPECT_EQ(extent.clipped, 0.0);
    EXPECT_LE(preset.maps.distance.full.value, 1.3 * extent.largest);
}

TEST(FittedRanges, APatchFitsToo) {
    Preset preset = small_preset("height");
    preset.shape.kind = FoamKind::Patch;
    preset.maps.height.full.value = 50.0;
    fit(preset);
    const NumberExtent extent = extent_of_all_frames(preset);
    EXPECT_EQ(extent.clipped, 0.0);
    EXPECT_LE(preset.maps.height.full.value, 1.3 * extent.largest);
}

// Their common divisors are 200 and 2. The reduced images must have exactly the same aspect ratio.
TEST(FittedRanges, ImagesOfAnyAspectRatioAreMeasured) {
    for (const auto& [width, height] : {std::pair(1000, 600), std::pair(1366, 768)}) {
        Preset preset = small_preset("height");
        preset.image.width = width;
        preset.image.height = height;
        fit(preset);
        EXPECT_EQ(extent_of_all_frames(preset).clipped, 0.0) << width;
    }
}

TEST(FittedRanges, FilesOfNumbersNeedNoRange) {
    Preset preset = small_preset("height");
    preset.output.pattern = "out/{map}.####.exr";
    EXPECT_FALSE(has_automatic_ranges(preset));
}

TEST(FittedRanges, AFixedRangeIsKept) {
    Preset preset = small_preset("height");
    preset.maps.height.full = {0.75};
    EXPECT_FALSE(has_automatic_ranges(preset));
    preset.image.maps = {"height", "area"};
    fit(preset);
    EXPECT_EQ(preset.maps.height.full, AutoReal{0.75});
}

TEST(FittedRanges, ReportsThePhasesOfTheSimulationAndItsOwn) {
    Preset preset = small_preset("area");
    std::vector<std::pair<Phase, int>> reports;
    fit_automatic_ranges(preset, simulation_of(preset, 1), {1, 2}, 1, [&](const RunProgress& p) {
        if (reports.empty() || reports.back() != std::pair(p.phase, p.done)) {
            reports.emplace_back(p.phase, p.done);
        }
    });
    EXPECT_EQ(reports,
              (std::vector<std::pair<Phase, int>>{{Phase::Seeding, 0},
                                                  {Phase::Equilibrium, 0},
                                                  {Phase::Ranges, 0},
                                                  {Phase::Ranges, 1},
                                                  {Phase::Ranges, 2}}));
}

TEST(FittedRanges, TheCallbackCanStopTheRun) {
    Preset preset = small_preset("area");
    const auto stop = [](const RunProgress& progress) {
        if (progress.phase == Phase::Ranges && progress.done == 1) {
            throw std::runtime_error("stopped");
        }
    };
    EXPECT_THROW(fit_automatic_ranges(preset, simulation_of(preset, 1), {1, 2, 3}, 1, stop),
                 std::runtime_error);
    EXPECT_TRUE(preset.maps.area.full.is_automatic);
}

}  // namespace
}  // namespace foam::texgen
