#include "texgen/bake/simulate_frames.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

Preset small_preset() {
    Preset preset;
    preset.seeding.bubbles = 60;
    preset.frames.time_step = 3.0;
    return preset;
}

struct Visit {
    int number;
    double time;
    FrameEffort effort;
};

std::vector<Visit> visits(const std::vector<int>& numbers) {
    Simulation simulation(small_preset(), 1);
    std::vector<Visit> all;
    const RunOutcome outcome =
        simulate_frames(simulation, numbers, NextFrames::LeftOut, [&](const SimulatedFrame& shown) {
            all.push_back({shown.frame->number, shown.frame->time, shown.effort});
        });
    EXPECT_EQ(outcome.status, RunStatus::Complete);
    return all;
}

TEST(SimulateFrames, HandsOutTheFramesInIncreasingOrder) {
    const std::vector<Visit> all = visits({4, 1, 2});
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].number, 1);
    EXPECT_EQ(all[1].number, 2);
    EXPECT_EQ(all[2].number, 4);
    EXPECT_NEAR(all[2].time, 9.0, 1e-12);
}

TEST(SimulateFrames, EffortsAddUpOverFramesInBetween) {
    const std::vector<Visit> each = visits({1, 2, 3, 4, 5, 6});
    const std::vector<Visit> two = visits({1, 6});
    FrameEffort sum;
    for (std::size_t k = 1; k < each.size(); ++k) {
        sum.t1 += each[k].effort.t1;
        sum.t2 += each[k].effort.t2;
    }
    EXPECT_GT(sum.t2, 0);
    EXPECT_EQ(two[1].effort.t1, sum.t1);
    EXPECT_EQ(two[1].effort.t2, sum.t2);
    EXPECT_EQ(two[1].effort.area_error, each.back().effort.area_error);
    EXPECT_EQ(two[0].effort.t1, each[0].effort.t1);
    EXPECT_GT(two[0].effort.seconds, 0.0);
}

// Of frames 2, 3 and 5; the simulation goes on to 6.
TEST(SimulateFrames, HandsOutTheFramesAfterThem) {
    Simulation simulation(small_preset(), 1);
    std::vector<std::pair<int, int>> pairs;
    std::vector<std::shared_ptr<const Frame>> frames;
    simulate_frames(simulation, {5, 2, 3}, NextFrames::HandedOut, [&](const SimulatedFrame& shown) {
        pairs.emplace_back(shown.frame->number, shown.next->number);
        frames.push_back(shown.frame);
        frames.push_back(shown.next);
    });
    EXPECT_EQ(pairs, (std::vector<std::pair<int, int>>{{2, 3}, {3, 4}, {5, 6}}));
    EXPECT_EQ(frames[1], frames[2]);
    EXPECT_EQ(simulation.number(), 6);
}

TEST(SimulateFrames, EffortsDoNotDependOnWhetherNextFramesAreHandedOut) {
    const std::vector<Visit> usual = visits({1, 4, 6});
    Simulation simulation(small_preset(), 1);
    std::size_t k = 0;
    simulate_frames(simulation, {1, 4, 6}, NextFrames::HandedOut, [&](const SimulatedFrame& shown) {
        EXPECT_EQ(shown.effort.t1, usual[k].effort.t1);
        EXPECT_EQ(shown.effort.t2, usual[k].effort.t2);
        EXPECT_EQ(shown.effort.area_error, usual[k].effort.area_error);
        ++k;
    });
    EXPECT_EQ(k, 3U);
}

// Six frames: 1 2 3 4 3 2 of the foam, each with the one that is shown after it.
TEST(SimulateFrames, APingpongComesBackFromItsMiddle) {
    Preset preset = small_preset();
    preset.loop.kind = LoopKind::PingPong;
    preset.frames.count = 6;
    preset.frames.step_growth = 1.0;
    Simulation simulation(preset, 1);
    std::map<int, std::pair<double, double>> times;
    simulate_frames(
        simulation, {1, 2, 3, 4, 5, 6}, NextFrames::HandedOut, [&](const SimulatedFrame& shown) {
            times[shown.frame->number] = {shown.frame->time, shown.next->time};
        });
    ASSERT_EQ(times.size(), 6U);
    const std::array<double, 7> steps = {0.0, 1.0, 2.0, 3.0, 2.0, 1.0, 0.0};
    for (int number = 1; number <= 6; ++number) {
        const auto k = static_cast<std::size_t>(number);
        const double step = preset.frames.time_step;
        EXPECT_NEAR(times[number].first, steps[k - 1] * step, 1e-12) << number;
        EXPECT_NEAR(times[number].second, steps[k] * step, 1e-12) << number;
    }
    EXPECT_EQ(simulation.number(), 4);
}

TEST(SimulateFrames, SaysHowFarALoopIsFromClosing) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.8, .cycles = 1};
    preset.frames.count = 6;
    Simulation simulation(preset, 1);
    const RunOutcome outcome =
        simulate_frames(simulation, {1}, NextFrames::LeftOut, [](const SimulatedFrame&) {
            FAIL() << "a frame of an open loop";
        });
    EXPECT_EQ(outcome.status, RunStatus::OpenLoop);
    EXPECT_GT(outcome.closing_error.value_or(0.0), 1e-9);
}

}  // namespace
}  // namespace foam::texgen
