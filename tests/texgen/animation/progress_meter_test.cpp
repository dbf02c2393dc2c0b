// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_meter.h"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace foam::texgen {
namespace {

SimulatedFrame frame_of_four_bubbles() {
    Frame frame;
    frame.number = 7;
    frame.bubbles.resize(3);
    frame.lone_bubbles.resize(1);
    SimulatedFrame shown;
    shown.frame = std::make_shared<const Frame>(frame);
    shown.effort.area_error = 1e-12;
    return shown;
}

TEST(ProgressMeter, ReportsTheBeginningAndEachFrame) {
    std::vector<RunProgress> reports;
    const ProgressCallback report = [&](const RunProgress& progress) {
        reports.push_back(progress);
    };
    ProgressMeter meter(Phase::Ranges, 2, report);
    meter.begin();
    meter.add(frame_of_four_bubbles());
    meter.begin();  // no effect
    meter.add(frame_of_four_bubbles());
    ASSERT_EQ(reports.size(), 3U);
    EXPECT_EQ(reports[0].done, 0);
    EXPECT_EQ(reports[1].done, 1);
    EXPECT_FALSE(reports[1].finished());
    EXPECT_EQ(reports[2].phase, Phase::Ranges);
    EXPECT_EQ(reports[2].total, 2);
    EXPECT_EQ(reports[2].frame, 7);
    EXPECT_EQ(reports[2].bubbles, 4);
    EXPECT_EQ(reports[2].area_error, 1e-12);
    EXPECT_TRUE(reports[2].finished());
    const ProgressCallback none;
    ProgressMeter(Phase::Files, 1, none).add();
}

TEST(ProgressMeter, ReportsOfTheSourceGiveWayToThePhase) {
    std::vector<RunProgress> reports;
    const ProgressCallback report = [&](const RunProgress& progress) {
        reports.push_back(progress);
    };
    ProgressMeter meter(Phase::Frames, 3, report);
    const ProgressCallback source = meter.for_source();
    source({.phase = Phase::States, .done = 4});
    meter.add(frame_of_four_bubbles());
    source({.phase = Phase::States, .done = 5});
    ASSERT_EQ(reports.size(), 3U);
    EXPECT_EQ(reports[0].phase, Phase::States);
    EXPECT_EQ(reports[0].done, 4);
    for (const std::size_t k : {1U, 2U}) {
        EXPECT_EQ(reports[k].phase, Phase::Frames);
        EXPECT_EQ(reports[k].done, 1);
    }
}

TEST(ProgressMeter, RethrowsTheExceptionsOfTheCallback) {
    const ProgressCallback stop = [](const RunProgress&) { throw std::runtime_error("stop"); };
    ProgressMeter meter(Phase::Frames, 3, stop);
    EXPECT_THROW(meter.for_source()({}), std::runtime_error);
    EXPECT_THROW(meter.add(), std::runtime_error);
    EXPECT_THROW(meter.add(), std::runtime_error);  // the mutex is free again
}

}  // namespace
}  // namespace foam::texgen
