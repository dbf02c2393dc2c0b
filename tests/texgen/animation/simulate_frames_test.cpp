// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/simulate_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
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
    std::vector<Visit> all;
    const RunOutcome outcome = simulate_frames(
        small_preset(), 1, numbers, NextFrames::Omitted, [&](const SimulatedFrame& shown) {
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

// Simulates a boil with a LoopMemory.
struct RememberedBoil {
    explicit RememberedBoil(const std::string& content, FoamKind shape = FoamKind::Torus)
        : kept(content) {
        Preset preset;
        preset.shape.kind = shape;
        preset.seeding.bubbles = 40;
        preset.frames.count = 24;
        preset.loop.kind = LoopKind::Boil;
        const LoopMemory memory{content, [&](const std::string& text) { kept = text; }};
        const auto add = [&](const SimulatedFrame& state) { states.push_back(state); };
        const auto count = [&](const RunProgress& progress) {
            cycles = std::max(cycles, progress.cycle);
        };
        EXPECT_EQ(simulate_states(preset, 1, {1, 2, 24}, add, count, memory).status,
                  RunStatus::Complete);
    }

    std::string kept;
    std::vector<SimulatedFrame> states;
    int cycles = 0;
};

class ShapesOfBoils : public testing::TestWithParam<FoamKind> {};

INSTANTIATE_TEST_SUITE_P(SimulateFrames,
                         ShapesOfBoils,
                         testing::Values(FoamKind::Torus, FoamKind::Patch));

// The states have the same bits whether the start of the boil was searched or known.
TEST_P(ShapesOfBoils, AreSearchedOnce) {
    const RememberedBoil searched("", GetParam());
    const RememberedBoil known(searched.kept, GetParam());
    EXPECT_GT(searched.cycles, 2);
    EXPECT_EQ(known.cycles, 1);
    ASSERT_EQ(searched.states.size(), known.states.size());
    for (std::size_t k = 0; k < known.states.size(); ++k) {
        const SimulatedFrame& a = searched.states[k];
        const SimulatedFrame& b = known.states[k];
        EXPECT_TRUE(std::ranges::equal(a.frame->positions, b.frame->positions)) << k;
        EXPECT_EQ(a.frame->time, b.frame->time) << k;
        EXPECT_EQ(a.record->births, b.record->births) << k;
        EXPECT_EQ(a.effort.t1, b.effort.t1) << k;
    }
}

TEST(SimulateFrames, AnUnusableStartOfABoilIsIgnored) {
    const RememberedBoil searched("");
    const std::string& text = searched.kept;
    for (const std::string& other :
         {std::string("{}"),
          text.substr(0, text.size() / 2),
          std::string(text).replace(text.find("\"amplitude\":") + 12, 1, "7")}) {
        const RememberedBoil again(other);
        EXPECT_GT(again.cycles, 2);
        EXPECT_EQ(again.kept, text);
    }
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

// The visitor receives frames 2, 3 and 5, each with the frame after it.
TEST(SimulateFrames, HandsOutTheFramesAfterThem) {
    std::vector<std::pair<int, int>> pairs;
    std::vector<std::shared_ptr<const Frame>> frames;
    simulate_frames(
        small_preset(), 1, {5, 2, 3}, NextFrames::Included, [&](const SimulatedFrame& shown) {
            pairs.emplace_back(shown.frame->number, shown.next->number);
            frames.push_back(shown.frame);
            frames.push_back(shown.next);
        });
    EXPECT_EQ(pairs, (std::vector<std::pair<int, int>>{{2, 3}, {3, 4}, {5, 6}}));
    EXPECT_EQ(frames[1], frames[2]);
}

TEST(SimulateFrames, EffortsDoNotDependOnWhetherNextFramesAreIncluded) {
    const std::vector<Visit> usual = visits({1, 4, 6});
    std::size_t k = 0;
    simulate_frames(
        small_preset(), 1, {1, 4, 6}, NextFrames::Included, [&](const SimulatedFrame& shown) {
            EXPECT_EQ(shown.effort.t1, usual[k].effort.t1);
            EXPECT_EQ(shown.effort.t2, usual[k].effort.t2);
            EXPECT_EQ(shown.effort.area_error, usual[k].effort.area_error);
            ++k;
        });
    EXPECT_EQ(k, 3U);
}

// The six frames of the loop show the states 1 2 3 4 3 2, each with the state that is shown after
// it.
TEST(SimulateFrames, APingpongReversesAtItsMiddle) {
    Preset preset = small_preset();
    preset.loop.kind = LoopKind::PingPong;
    preset.frames.count = 6;
    preset.frames.step_growth = 1.0;
    std::map<int, std::pair<double, double>> times;
    simulate_frames(
        preset, 1, {1, 2, 3, 4, 5, 6}, NextFrames::Included, [&](const SimulatedFrame& shown) {
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
}

TEST(FrameAssembly, NeedsTheStatesOfItsFramesAndThoseAfterThem) {
    Preset preset;
    EXPECT_EQ(FrameAssembly(preset, {5, 2, 3}, NextFrames::Omitted, {}).states(),
              (std::vector<int>{1, 2, 3, 5}));
    EXPECT_EQ(FrameAssembly(preset, {5, 2, 3}, NextFrames::Included, {}).states(),
              (std::vector<int>{1, 2, 3, 4, 5, 6}));
    preset.loop.kind = LoopKind::PingPong;
    preset.frames.count = 6;
    EXPECT_EQ(FrameAssembly(preset, {5, 6}, NextFrames::Included, {}).states(),
              (std::vector<int>{1, 2, 3}));
}

// The last four of eight frames fade. The frames show states 5 to 12; the last four also show
// states 1 to 4. The next frame of each frame is the frame that is shown after it.
TEST(SimulateFrames, AFlowFadesIntoItsBeginning) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Flow, .fade = 0.5};
    preset.frames.count = 8;
    const double step = preset.frames.time_step;
    std::vector<int> numbers;
    std::shared_ptr<const Frame> first;
    std::shared_ptr<const Frame> last_next;
    std::shared_ptr<const Frame> next;
    simulate_frames(preset,
                    1,
                    {1, 2, 3, 4, 5, 6, 7, 8},
                    NextFrames::Included,
                    [&](const SimulatedFrame& shown) {
                        const int number = shown.frame->number;
                        numbers.push_back(number);
                        first = number == 1 ? shown.frame : first;
                        last_next = shown.fading_in.next;
                        if (next) {
                            EXPECT_EQ(next->positions, shown.frame->positions) << number;
                        }
                        next = shown.next;
                        EXPECT_NEAR(shown.frame->time, (3 + number) * step, 1e-9);
                        EXPECT_NEAR(shown.next->time, (4 + number) * step, 1e-9);
                        ASSERT_EQ(shown.fading_in.frame != nullptr, number > 4);
                        if (number > 4) {
                            EXPECT_NEAR(shown.fading_in.frame->time, (number - 5) * step, 1e-9);
                            EXPECT_NEAR(shown.fading_in.next->time, (number - 4) * step, 1e-9);
                            EXPECT_EQ(shown.fading_in.record->frame, number - 4);
                        }
                    });
    EXPECT_EQ(numbers, (std::vector<int>{1, 2, 3, 4, 5, 6, 7, 8}));
    ASSERT_TRUE(first && last_next);
    EXPECT_EQ(first->positions, last_next->positions);
}

TEST(SimulateFrames, ReportsTheClosingErrorOfALoop) {
    Preset preset = small_preset();
    preset.loop = {.kind = LoopKind::Breathe, .amplitude = 0.8, .cycles = 1};
    preset.frames.count = 6;
    const RunOutcome outcome =
        simulate_frames(preset, 1, {1}, NextFrames::Omitted, [](const SimulatedFrame&) {
            FAIL() << "a frame of an open loop";
        });
    EXPECT_EQ(outcome.status, RunStatus::OpenLoop);
    EXPECT_GT(outcome.closing_error.value_or(0.0), 1e-9);
}

// The states 2 and 3 are not frames of the run, nor are the states 5 and 6.
TEST(SimulateFrames, ReportsStatesBetweenFrames) {
    std::vector<std::pair<Phase, int>> reports;
    simulate_frames(
        small_preset(),
        1,
        {4, 7},
        NextFrames::Omitted,
        [](const SimulatedFrame&) {},
        [&](const RunProgress& progress) {
            reports.emplace_back(progress.phase, progress.done);
            EXPECT_EQ(progress.total, progress.phase == Phase::States ? 7 : 0);
        });
    EXPECT_EQ(reports,
              (std::vector<std::pair<Phase, int>>{{Phase::Seeding, 0},
                                                  {Phase::Equilibrium, 0},
                                                  {Phase::States, 1},
                                                  {Phase::States, 2},
                                                  {Phase::States, 3},
                                                  {Phase::States, 4},
                                                  {Phase::States, 5},
                                                  {Phase::States, 6}}));
}

TEST(SimulateFrames, ARunTellsWhyItFailed) {
    const auto failure = [](RunStatus status, std::optional<double> closing_error) {
        return failure_of({status, 7, closing_error});
    };
    EXPECT_EQ(failure(RunStatus::Complete, std::nullopt), "");
    EXPECT_EQ(failure(RunStatus::NoEquilibrium, std::nullopt),
              "frame 7: the foam did not reach equilibrium");
    const std::string open = "the loop does not close: ";
    EXPECT_EQ(failure(RunStatus::OpenLoop, 0.0125),
              open +
                  "at the end of its last cycle, bubbles are up to 0.013 mean bubble diameters "
                  "away from their positions at its start");
    EXPECT_EQ(failure(RunStatus::OpenLoop, std::numeric_limits<double>::infinity()),
              open +
                  "at the end of its last cycle, bubbles are missing or have other neighbors "
                  "than at its start");
    // A boil has to close twice in a row.
    EXPECT_EQ(failure(RunStatus::OpenLoop, 1e-12),
              open +
                  "the foam returned to its start in the last cycle, but a boil must do so in two "
                  "cycles in a row, with the births at the same places");
}

}  // namespace
}  // namespace foam::texgen
