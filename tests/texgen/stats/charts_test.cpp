// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/charts.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/stats/runs.h"
#include "texgen/image/external_program.h"
#include "texgen/stats/files.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

using test::run_of;

/// Draws the charts of runs. Skips the tests if gnuplot is not installed.
class Charts : public testing::Test {
  protected:
    void SetUp() override {
        if (!run_external({"gnuplot", "--version"})) {
            GTEST_SKIP() << "there is no gnuplot";
        }
    }

    void draw(const RunRecord& run) {
        EXPECT_EQ(write_statistics(run, folder_.path()).charts, ChartStatus::Drawn);
    }

    bool has_chart(const std::string& name) const {
        return std::filesystem::exists(folder_.path() / (name + ".svg"));
    }

    /// Returns true if a chart contains a text, such as a title in its key.
    bool shows(const std::string& name, const std::string& text) const {
        const Bytes bytes = read_file(folder_.path() / (name + ".svg"), kImageInput);
        const std::string svg(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        return svg.find(text) != std::string::npos;
    }

    TemporaryFolder folder_;
};

/// Returns a run of three frames with bubbles of three numbers of sides.
RunRecord run_of_kinds() {
    RunRecord run = run_of({{0.0, 12}, {1.0, 11}, {2.0, 10}});
    for (FrameRecord& record : run.frames) {
        record.foam.by_sides = {{3, 1, 1.0, 0.1, 0.2}, {6, 8, 1.0, 0.1, 0.2}, {14, 1, 9.0, 0.1, 2}};
        record.growth = {{6, 8, 0.0}};
        record.effort.seconds = 0.5;
    }
    return run;
}

TEST_F(Charts, AreAllDrawnOfThreeFrames) {
    draw(run_of_kinds());
    for (const char* const name :
         {"mean_area", "second_moment", "sides", "pressures", "growth_rates", "seconds"}) {
        EXPECT_TRUE(has_chart(name)) << name;
    }
    EXPECT_TRUE(shows("sides", "n = 3"));
    EXPECT_TRUE(shows("sides", "n = 6"));
    EXPECT_TRUE(shows("growth_rates", "number of sides n"));
    EXPECT_TRUE(shows("seconds", "time of a frame (s)"));
}

// A lone bubble has no sides.
TEST_F(Charts, AreAllDrawnWithLoneBubbles) {
    RunRecord run = run_of_kinds();
    run.frames.back().foam.by_sides.insert(run.frames.back().foam.by_sides.begin(),
                                           {0, 1, 1.0, 0.1, 0.2});
    draw(run);
    EXPECT_TRUE(has_chart("growth_rates"));
    EXPECT_TRUE(has_chart("seconds"));
}

TEST_F(Charts, AreDrawnForAnyRun) {
    draw({});
    EXPECT_FALSE(has_chart("mean_area"));
    RunRecord one = run_of_kinds();
    one.frames.resize(1);
    draw(one);
    EXPECT_TRUE(has_chart("mean_area"));
    EXPECT_TRUE(has_chart("seconds"));
    EXPECT_FALSE(has_chart("sides"));  // the first frame has the time 0, which has no logarithm
}

// The mean area, 4000 / bubbles, is 2 + t/2 once only a quarter of the bubbles is left, at t = 4.
// Before that it is not. The last frame has too few bubbles and is ignored.
TEST_F(Charts, MeanAreaHasALineThroughTheScalingState) {
    RunRecord run = run_of_kinds();
    const auto kinds = run.frames.front().foam.by_sides;
    run = run_of({{0.0, 4000}, {2.0, 3900}, {4.0, 1000}, {12.0, 500}, {16.0, 400}, {90.0, 99}});
    run.frames.front().foam.by_sides = kinds;
    draw(run);
    EXPECT_TRUE(shows("mean_area", "2 + 0.5 t, R² = 1.0000"));
}

// The mean is over the frames with at most a quarter of the bubbles, weighted by the number of
// bubbles: (300 * 1.5 + 100 * 1.1) / 400 = 1.4. The last frame has too few bubbles.
TEST_F(Charts, SecondMomentHasItsMeanInTheScalingState) {
    RunRecord run = run_of({{0.0, 1200}, {8.0, 300}, {9.0, 100}, {10.0, 30}});
    run.frames[0].foam.by_sides = run_of_kinds().frames.front().foam.by_sides;
    run.frames[1].foam.second_moment = 1.5;
    run.frames[2].foam.second_moment = 1.1;
    draw(run);
    EXPECT_TRUE(shows("second_moment", "mean 1.40"));
    EXPECT_TRUE(shows("second_moment", "soap froths, 1.4 ± 0.1"));
}

// 9 of 1000 bubbles are less than 1 % and are left out, 10 are not.
TEST_F(Charts, PressuresLeaveOutRareBubbles) {
    RunRecord run = run_of({{0.0, 1000}, {1.0, 1000}, {2.0, 1000}});
    for (std::size_t k = 1; k < 3; ++k) {
        run.frames[k].foam.by_sides = {{3, 9, 1.0, 20.0, 0.0}, {5, 10, 1.0, 20.0, 0.0}};
    }
    draw(run);
    EXPECT_FALSE(shows("pressures", "n = 3"));
    EXPECT_TRUE(shows("pressures", "n = 5"));
    EXPECT_TRUE(shows("sides", "n = 3"));
}

// The stress grows by the modulus 0.5 up to 0.1 at the strain 0.2, where the foam yields.
TEST_F(Charts, StressIsDrawnOverStrainIfTheFoamIsSheared) {
    RunRecord run = run_of_kinds();
    draw(run);
    EXPECT_FALSE(has_chart("stress"));
    RunRecord one = run;
    one.frames.resize(1);
    one.frames[0].effort.strain = 0.2;
    draw(one);
    EXPECT_FALSE(has_chart("stress"));
    const std::vector<double> strains{0.0, 0.2, 0.4};
    const std::vector<double> stresses{0.0, 0.1, 0.08};
    for (std::size_t k = 0; k < 3; ++k) {
        run.frames[k].foam.mean_area = 1.0;
        run.frames[k].effort.strain = strains[k];
        run.frames[k].effort.stress(0, 1) = run.frames[k].effort.stress(1, 0) = stresses[k];
    }
    draw(run);
    EXPECT_TRUE(has_chart("stress"));
    EXPECT_TRUE(shows("stress", "0.1 at strain 0.2"));
    EXPECT_FALSE(shows("stress", "shear modulus"));
    run.frames[0].shear_modulus = 0.5;
    draw(run);
    EXPECT_TRUE(shows("stress", "shear modulus 0.5"));
}

}  // namespace
}  // namespace foam::texgen
