// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/measure_run.h"

#include "tests/support/temporary_folder.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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
    std::int64_t t1 = 0;
    std::int64_t t2 = 0;
    for (const FrameRecord& record : all) {
        t1 += record.effort.t1;
        t2 += record.effort.t2;
        EXPECT_EQ(record.foam.bubbles, 80 - t2);
    }
    EXPECT_GT(t2, 0);
    EXPECT_EQ(last.at(0).effort.t1, t1);
    EXPECT_EQ(last.at(0).effort.t2, t2);
}

int count_of(TopologyEventKind kind, const FrameRecord& record) {
    return static_cast<int>(std::ranges::count(record.effort.events, kind, &TopologyEvent::kind));
}

// The list of events contains every T1 and T2 once, in the order of time, whichever frames are
// measured.
TEST(MeasureRun, EventsAreListed) {
    std::vector<TopologyEvent> listed;
    for (const FrameRecord& record : measure({1, 2, 3, 4, 5, 6, 7, 8}).run.frames) {
        EXPECT_EQ(count_of(TopologyEventKind::T1, record), record.effort.t1);
        EXPECT_EQ(count_of(TopologyEventKind::T2, record), record.effort.t2);
        for (const TopologyEvent& event : record.effort.events) {
            EXPECT_LE(event.time, record.time);
            EXPECT_TRUE(listed.empty() || event.time >= listed.back().time);
            listed.push_back(event);
        }
    }
    EXPECT_EQ(measure({8}).run.frames.at(0).effort.events, listed);
    EXPECT_FALSE(listed.empty());
}

// The event shears the foam by 0.3 in the steps to the frames 2 to 4.
TEST(MeasureRun, RecordsTheStrainAndStressOfAShearedFoam) {
    Preset preset = small_preset();
    preset.coarsening.kappa = 0.0;
    assign(preset,
           read_assignments("[[event]]\nkind = 'shear'\nframes = [2, 4]\nstrain = 0.3\n", "test"));
    const MeasureSummary summary = measure_run(preset, {.frames = {1, 3, 4, 5}, .threads = 1}, {});
    ASSERT_EQ(summary.run.frames.size(), 4U);
    const std::vector<double> strains{0.0, 0.2, 0.3, 0.3};
    for (std::size_t k = 0; k < 4; ++k) {
        const FrameRecord& record = summary.run.frames[k];
        EXPECT_NEAR(record.effort.strain, strains[k], 1e-12);
        EXPECT_NEAR(record.effort.energy, record.foam.energy, 1e-9 * record.foam.energy);
        EXPECT_NEAR(record.effort.stress.trace() * 80.0, record.effort.energy, 1e-9);
        EXPECT_GT(record.shear_modulus.value(), 0.0);
    }
    EXPECT_LT(std::abs(summary.run.frames[0].effort.stress(0, 1)), 0.05);
    EXPECT_GT(summary.run.frames[1].effort.stress(0, 1), 0.05);
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
