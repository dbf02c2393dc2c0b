#include "texgen/bake/simulate_frames.h"

#include <gtest/gtest.h>

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
    EXPECT_TRUE(
        simulate_frames(simulation,
                        numbers,
                        [&](const std::shared_ptr<const Frame>& frame, const FrameEffort& effort) {
                            all.push_back({frame->number, frame->time, effort});
                        }));
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

}  // namespace
}  // namespace foam::texgen
