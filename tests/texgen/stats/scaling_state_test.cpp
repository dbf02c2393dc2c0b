#include "texgen/stats/scaling_state.h"

#include "tests/texgen/stats/runs.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

using test::run_of;

std::vector<int> numbers(std::span<const FrameRecord> records) {
    std::vector<int> all;
    for (const FrameRecord& record : records) {
        all.push_back(record.frame);
    }
    return all;
}

using Numbers = std::vector<int>;

TEST(ScalingState, IsFromAQuarterOfTheBubblesToAHundred) {
    const RunRecord run =
        run_of({{0.0, 1000}, {1.0, 251}, {2.0, 250}, {3.0, 180}, {4.0, 100}, {5.0, 99}, {6.0, 3}});
    EXPECT_EQ(numbers(measurable(run)), (Numbers{1, 2, 3, 4, 5}));
    EXPECT_EQ(numbers(scaling_state(run)), (Numbers{3, 4, 5}));
}

TEST(ScalingState, MayNotBeReached) {
    const RunRecord run = run_of({{0.0, 1000}, {1.0, 251}});
    EXPECT_EQ(numbers(measurable(run)), (Numbers{1, 2}));
    EXPECT_TRUE(scaling_state(run).empty());
    EXPECT_TRUE(scaling_state({}).empty());
}

TEST(ScalingState, ASmallFoamIsMeasurableAllTheSame) {
    const RunRecord run = run_of({{0.0, 99}, {1.0, 24}, {2.0, 2}});
    EXPECT_EQ(numbers(measurable(run)), (Numbers{1, 2, 3}));
    EXPECT_EQ(numbers(scaling_state(run)), (Numbers{2, 3}));
}

}  // namespace
}  // namespace foam::texgen
