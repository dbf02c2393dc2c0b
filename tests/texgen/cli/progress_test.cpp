// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/progress.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Progress, TheBarFillsInProportion) {
    // 12 of 48 frames took 5 s. A quarter of the 24 characters is filled, and 36 frames of 5/12 s
    // each remain.
    const RunProgress quarter{.frame = 12, .done = 12, .total = 48, .bubbles = 583, .seconds = 5.0};
    EXPECT_EQ(progress_bar(quarter), "[######------------------] 12/48  583 bubbles  0:15 left");
    const RunProgress last{.frame = 48, .done = 48, .total = 48, .bubbles = 9, .seconds = 100.0};
    EXPECT_EQ(progress_bar(last), "[########################] 48/48  9 bubbles  0:00 left");
}

TEST(Progress, HasNoEstimateBeforeTheFirstFrame) {
    const RunProgress none{.total = 100, .bubbles = 7, .seconds = 3.0};
    EXPECT_EQ(progress_bar(none), "[------------------------]   0/100  7 bubbles");
}

TEST(Progress, TheLineHasTheErrorsOfTheFrame) {
    const RunProgress progress{.frame = 3,
                               .done = 1,
                               .total = 2,
                               .bubbles = 600,
                               .area_error = 1.24e-14,
                               .angle_error = 3e-15,
                               .seconds = 4.211};
    EXPECT_EQ(progress_line(progress),
              "frame 3: 600 bubbles, area error 1.2e-14, angle error 3.0e-15, 4.21 s");
}

}  // namespace
}  // namespace foam::texgen
