// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/measure_run.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

namespace foam::texgen {
namespace {

Preset small_preset() {
    Preset preset;
    preset.name = "small";
    preset.seeding.bubbles = 80;
    preset.frames.time_step = 4.0;
    preset.image.width = 16;
    preset.image.height = 16;
    return preset;
}

MeasureSummary measure(const std::vector<int>& frames) {
    return measure_run(small_preset(), {.frames = frames, .threads = 1}, {});
}

TEST(MeasureRun, HasARecordForEachFrameAskedForInOrder) {
    const MeasureSummary summary = measure({5, 1, 3});
    EXPECT_EQ(summary.outcome.status, RunStatus::Complete);
    ASSERT_EQ(summary.run.frames.size(), 3U);
    for (const int k : {0, 1, 2}) {
        const FrameRecord& record = summary.run.frames[static_cast<std::size_t>(k)];
        EXPECT_EQ(record.frame, 1 + 2 * k);
        EXPECT_NEAR(record.time, 8.0 * k, 1e-12);
        EXPECT_LT(record.effort.area_error, 1e-9);
        EXPECT_LT(record.effort.angle_error, 1e-9);
        EXPECT_EQ(record.foam.mean_sides, 6.0);
    }
}

// There is a T2 for every bubble that has vanished, whichever frames are measured.
TEST(MeasureRun, EventsAddUp) {
    const std::vector<FrameRecord> all = measure({1, 2, 3, 4, 5, 6, 7, 8}).run.frames;
    const std::vector<FrameRecord> last = measure({8}).run.frames;
    int t1 = 0;
    int t2 = 0;
    for (const FrameRecord& record : all) {
        t1 += record.effort.t1;
        t2 += record.effort.t2;
        EXPECT_EQ(record.foam.bubbles, 80 - t2);
    }
    EXPECT_GT(t2, 0);
    EXPECT_EQ(last.at(0).effort.t1, t1);
    EXPECT_EQ(last.at(0).effort.t2, t2);
}

TEST(MeasureRun, GrowthBetweenEventsIsVonNeumanns) {
    const RunRecord run = measure({1, 2, 3, 4, 5, 6}).run;
    for (std::size_t k = 1; k < run.frames.size(); ++k) {
        for (const SidesGrowth& part : run.frames[k].growth) {
            EXPECT_NEAR(part.mean_rate, run.law_rate(part.sides), 1e-9) << part.sides;
        }
    }
}

TEST(MeasureRun, ReportsEveryFrame) {
    std::vector<RunProgress> seen;
    measure_run(small_preset(), {.frames = {2, 4}, .threads = 1}, [&](const RunProgress& p) {
        if (p.phase == Phase::Frames && (seen.empty() || seen.back().done != p.done)) {
            seen.push_back(p);
        }
    });
    ASSERT_EQ(seen.size(), 2U);
    EXPECT_EQ(seen[0].frame, 2);
    EXPECT_EQ(seen[0].done, 1);
    EXPECT_EQ(seen[1].frame, 4);
    EXPECT_EQ(seen[1].done, 2);
    EXPECT_EQ(seen[1].total, 2);
    EXPECT_GT(seen[1].bubbles, 0);
}

// A bake passes the same frames to its callback that are measured without drawing.
TEST(MeasureRun, ABakeMeasuresTheSame) {
    const TemporaryFolder folder;
    Preset preset = small_preset();
    preset.output.pattern = (folder.path() / "####.png").string();
    Recorder recorder(preset);
    bake(preset, {.frames = {3, 2}, .threads = 2}, {.on_frame = recorder.visitor()});
    const std::vector<FrameRecord>& baked = recorder.run().frames;
    const std::vector<FrameRecord> measured = measure({2, 3}).run.frames;
    ASSERT_EQ(baked.size(), 2U);
    for (const std::size_t k : {0U, 1U}) {
        EXPECT_EQ(baked[k].frame, measured[k].frame);
        EXPECT_EQ(baked[k].foam.energy, measured[k].foam.energy);
        EXPECT_EQ(baked[k].foam.second_moment, measured[k].foam.second_moment);
        EXPECT_EQ(baked[k].effort.t1, measured[k].effort.t1);
    }
}

}  // namespace
}  // namespace foam::texgen
