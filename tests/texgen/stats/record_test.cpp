// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/record.h"

#include "core/foam/honeycomb.h"

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <optional>

namespace foam::texgen {
namespace {

// gamma = 1/4 and kappa = 0.3, so the law is (2 pi/3) (1/4) (0.3) (n - 6) = (pi/20) (n - 6).
TEST(Record, TheLawIsVonNeumanns) {
    Preset preset;
    preset.name = "quarter";
    preset.seeding.surface_tension = 0.25;
    preset.coarsening.kappa = 0.3;
    const Recorder recorder(preset);
    EXPECT_EQ(recorder.run().preset, "quarter");
    EXPECT_EQ(recorder.run().film_tension, 0.5);
    EXPECT_NEAR(recorder.run().law_rate(3), -3.0 * std::numbers::pi / 20.0, 1e-15);
    EXPECT_NEAR(recorder.run().law_rate(8), std::numbers::pi / 10.0, 1e-15);
}

TEST(Record, GrowthIsSinceTheRecordBefore) {
    Frame frame = snapshot(honeycomb(4, 4), 2);
    Recorder recorder({});
    recorder.record(std::make_shared<const Frame>(frame), {.t1 = 7});
    frame.number = 5;
    frame.time = 2.0;
    frame.bubbles[BubbleId{3}].area += 1.6;  // 0.1 in the mean over 16 bubbles
    recorder.record(std::make_shared<const Frame>(frame), {.t1 = 1, .seconds = 0.5});

    ASSERT_EQ(recorder.run().frames.size(), 2U);
    const FrameRecord& first = recorder.run().frames[0];
    EXPECT_EQ(first.frame, 2);
    EXPECT_EQ(first.foam.bubbles, 16);
    EXPECT_EQ(first.effort.t1, 7);
    EXPECT_TRUE(first.growth.empty());
    const FrameRecord& second = recorder.run().frames[1];
    EXPECT_EQ(second.frame, 5);
    EXPECT_EQ(second.time, 2.0);
    EXPECT_EQ(second.effort.seconds, 0.5);
    ASSERT_EQ(second.growth.size(), 1U);
    EXPECT_EQ(second.growth[0].bubbles, 16);
    EXPECT_NEAR(second.growth[0].mean_rate, 0.05, 1e-15);
}

// In a tree the numbers of open films of all bubbles add up to twice the number of bubbles less 2.
// So there are at least as many dead ends as branches, plus 2.
TEST(Record, MazesAreMeasuredOnlyIfTheyAreDrawn) {
    const auto frame = std::make_shared<const Frame>(snapshot(honeycomb(4, 4), 1));
    Preset preset;
    Recorder without(preset);
    without.record(frame, {});
    EXPECT_FALSE(without.run().frames[0].maze.has_value());
    preset.image.maps = {"albedo", "normal"};
    preset.maps.relief.films = ReliefFilms::Walls;
    Recorder relief(preset);
    relief.record(frame, {});
    EXPECT_TRUE(relief.run().frames[0].maze.has_value());
    preset.image.maps = {"maze"};
    Recorder with(preset);
    with.record(frame, {});
    const std::optional<MazeStatistics> maze = with.run().frames[0].maze;
    ASSERT_TRUE(maze.has_value());
    EXPECT_GE(maze->dead_ends, maze->branches + 2);
    EXPECT_GE(maze->solution, 3);
    EXPECT_LE(maze->solution, 16);
}

}  // namespace
}  // namespace foam::texgen
