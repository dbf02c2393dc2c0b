// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/target_area_schedule.h"

#include <gtest/gtest.h>

namespace foam {
namespace {

TEST(TargetAreaSchedule, IsARampWithoutOscillations) {
    const TargetAreaSchedule schedule{.from = 2.0, .to = 0.5};
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.0), 2.0);
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.5), 1.25);
    EXPECT_DOUBLE_EQ(target_at(schedule, 1.0), 0.5);
}

// Two oscillations: the first quarter of one is reached after an eighth of the time.
TEST(TargetAreaSchedule, OscillatesAroundItsArea) {
    const TargetAreaSchedule schedule{
        .from = 2.0, .to = 2.0, .amplitude = 0.25, .oscillations = 2.0};
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.0), 2.0);
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.125), 2.5);
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.25), 2.0);
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.375), 1.5);
    EXPECT_NEAR(target_at(schedule, 1.0), 2.0, 1e-15);
}

TEST(TargetAreaSchedule, APhaseOfAQuarterTurnStartsAtTheTop) {
    const TargetAreaSchedule schedule{
        .from = 1.0, .to = 3.0, .amplitude = 0.5, .oscillations = 1.0, .phase = 0.25};
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.0), 1.5);
    EXPECT_DOUBLE_EQ(target_at(schedule, 0.5), 1.0);  // 2 at the bottom
    EXPECT_DOUBLE_EQ(target_at(schedule, 1.0), 4.5);
}

}  // namespace
}  // namespace foam
