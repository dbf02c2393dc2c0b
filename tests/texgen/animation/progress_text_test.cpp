// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/progress_text.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace foam::texgen {
namespace {

TEST(ProgressText, EachPhaseHasItsOwnMeasure) {
    EXPECT_EQ(phase_text({.phase = Phase::Seeding}), "placing the bubbles");
    EXPECT_EQ(phase_text({.phase = Phase::WarmUp, .done = 40, .total = 60}), "warm-up 40 of 60");
    EXPECT_EQ(phase_text({.phase = Phase::Frames, .done = 3, .total = 48}), "frame 3 of 48");
    EXPECT_EQ(phase_text({.phase = Phase::Ranges, .done = 3, .total = 48}),
              "ranges: frame 3 of 48");
    RunProgress closing{.phase = Phase::LoopClosing, .done = 12, .total = 48, .cycle = 3};
    EXPECT_EQ(phase_text(closing), "closing the loop: cycle 3 (12/48)");
    closing.measure = std::numeric_limits<double>::infinity();
    EXPECT_EQ(phase_text(closing), "closing the loop: cycle 3 (12/48)");
    closing.measure = 1.2e-4;
    EXPECT_EQ(phase_text(closing), "closing the loop: cycle 3 (12/48), error 1e-04");
    closing.usual_cycles = 20;
    EXPECT_EQ(phase_text(closing), "closing the loop: cycle 3 of about 20 (12/48), error 1e-04");
    closing.cycle = 21;
    EXPECT_EQ(phase_text(closing), "closing the loop: cycle 21 (12/48), error 1e-04");
}

TEST(ProgressText, TheBarFillsInProportion) {
    const RunProgress quarter{.done = 12, .total = 48, .frame = 12, .bubbles = 583};
    EXPECT_EQ(progress_bar(quarter, {.left = 14.2}),
              "[######------------------] frame 12 of 48  583 bubbles  0:15 left");
    const RunProgress last{.done = 48, .total = 48, .frame = 48, .bubbles = 9};
    EXPECT_EQ(progress_bar(last, {.left = 0.0}),
              "[########################] frame 48 of 48  9 bubbles  0:00 left");
    EXPECT_EQ(progress_bar({.total = 100, .bubbles = 7}, {}),
              "[------------------------] frame 0 of 100  7 bubbles");
    EXPECT_EQ(progress_bar({.phase = Phase::Equilibrium, .bubbles = 7}, {}),
              "[------------------------] finding the first equilibrium  7 bubbles");
}

TEST(ProgressText, TheBarHasTheTimeSoFarUntilAUnitIsDone) {
    EXPECT_EQ(progress_bar({.phase = Phase::Equilibrium}, {.passed = 72.9}),
              "[------------------------] finding the first equilibrium  1:12 so far");
    EXPECT_EQ(progress_bar({.total = 9}, {.passed = 2.0}),
              "[------------------------] frame 0 of 9  0:02 so far");
    EXPECT_EQ(progress_bar({.total = 9}, {.passed = 0.9}),
              "[------------------------] frame 0 of 9");
    EXPECT_EQ(progress_bar({.done = 3, .total = 9}, {.passed = 2.0}),
              "[########----------------] frame 3 of 9");
}

// A bar that wraps cannot be drawn over.
TEST(ProgressText, TheLongestBarsFitATerminalOf80Columns) {
    const RunProgress closing{.phase = Phase::LoopClosing,
                              .done = 100,
                              .total = 100,
                              .measure = 1e-10,
                              .cycle = 100,
                              .bubbles = 10000};
    EXPECT_LT(progress_bar(closing, {}).size(), 80U);
    const RunProgress ranges{
        .phase = Phase::Ranges, .done = 100, .total = 960, .frame = 100, .bubbles = 10000};
    EXPECT_LT(progress_bar(ranges, {.left = 750.0}).size(), 80U);
}

TEST(ProgressText, TheLineHasTheErrorsOfTheFrame) {
    const RunProgress progress{.done = 1,
                               .total = 2,
                               .frame = 3,
                               .bubbles = 600,
                               .area_error = 1.24e-14,
                               .angle_error = 3e-15};
    EXPECT_EQ(progress_line(progress, 4.211),
              "frame 3: 600 bubbles, area error 1.2e-14, angle error 3.0e-15, 4.21 s");
    EXPECT_EQ(progress_line({.phase = Phase::Files, .done = 1, .total = 2}, 0.5),
              "file 1 of 2, 0.50 s");
}

TEST(ProgressText, JsonHasNullForWhatIsUnknown) {
    EXPECT_EQ(progress_json({.phase = Phase::Equilibrium, .bubbles = 9}, 0.12345, {}),
              R"({"phase":"equilibrium","done":0,"total":null,"seconds":0.123,)"
              R"("seconds_left":null,"frame":null,"bubbles":9,"cycle":null,"measure":null})");
    EXPECT_EQ(progress_json({.phase = Phase::LoopClosing,
                             .done = 4,
                             .total = 12,
                             .measure = 0.5,
                             .cycle = 2,
                             .bubbles = 9},
                            3.0,
                            std::nullopt),
              R"({"phase":"loop_closing","done":4,"total":12,"seconds":3.0,)"
              R"("seconds_left":null,"frame":null,"bubbles":9,"cycle":2,"measure":0.5})");
    const auto frame = nlohmann::json::parse(
        progress_json({.done = 3, .total = 12, .frame = 7, .bubbles = 9}, 3.0, 8.25));
    EXPECT_EQ(frame["phase"], "frames");
    EXPECT_EQ(frame["seconds_left"], 8.25);
    EXPECT_EQ(frame["frame"], 7);
}

TEST(ProgressText, LongDurationsAreRoundedUp) {
    EXPECT_EQ(long_duration(60.0), "1 minute");
    EXPECT_EQ(long_duration(61.0), "2 minutes");
    EXPECT_EQ(long_duration(5000.0), "84 minutes");
    EXPECT_EQ(long_duration(7200.0), "2.0 hours");
    EXPECT_EQ(long_duration(9001.0), "2.6 hours");
}

}  // namespace
}  // namespace foam::texgen
