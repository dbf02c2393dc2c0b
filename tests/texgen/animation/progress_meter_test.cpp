// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_meter.h"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ProgressMeter, ReportsEachFrame) {
    Frame frame;
    frame.number = 7;
    frame.bubbles.resize(3);
    frame.lone_bubbles.resize(1);
    SimulatedFrame shown;
    shown.frame = std::make_shared<const Frame>(frame);
    shown.effort.area_error = 1e-12;
    std::vector<RunProgress> reports;
    const ProgressCallback report = [&](const RunProgress& progress) {
        reports.push_back(progress);
    };
    ProgressMeter meter(2, report);
    meter.add(shown);
    meter.add(shown);
    ASSERT_EQ(reports.size(), 2U);
    EXPECT_EQ(reports[0].done, 1);
    EXPECT_EQ(reports[1].done, 2);
    EXPECT_EQ(reports[1].total, 2);
    EXPECT_EQ(reports[1].frame, 7);
    EXPECT_EQ(reports[1].bubbles, 4);
    EXPECT_EQ(reports[1].area_error, 1e-12);
    EXPECT_GE(reports[1].seconds, reports[0].seconds);
    const ProgressCallback none;
    ProgressMeter(1, none).add(shown);
}

}  // namespace
}  // namespace foam::texgen
