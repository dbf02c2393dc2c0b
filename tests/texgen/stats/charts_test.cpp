#include "texgen/stats/charts.h"

#include "tests/texgen/chart/well_formed.h"
#include "tests/texgen/stats/runs.h"
#include "texgen/chart/svg_chart.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace foam::texgen {
namespace {

using test::run_of;

Chart chart_of(const RunRecord& run, const std::string& name) {
    const std::vector<NamedChart> all = charts(run);
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const NamedChart& c) { return c.name == name; });
    EXPECT_NE(found, all.end()) << name;
    return found != all.end() ? found->chart : Chart{};
}

TEST(Charts, AreWellFormedWhateverTheRun) {
    RunRecord run = run_of({{0.0, 12}, {1.0, 11}});
    run.frames[1].foam.by_sides = {
        {2, 1, 1.0, 0.1, 0.2}, {6, 9, 1.0, 0.1, 0.2}, {14, 1, 9.0, 0.1, 0.2}};
    run.frames[1].growth = {{6, 8, 0.0}};
    for (const RunRecord& one : {RunRecord{}, run_of({{0.0, 5}}), run}) {
        EXPECT_EQ(charts(one).size(), 6U);
        for (const NamedChart& named : charts(one)) {
            EXPECT_TRUE(test::is_well_formed(to_svg(named.chart))) << named.name;
        }
    }
}

// 4000/bubbles = 2 + t/2 from the quarter of the bubbles on, at t = 4; before it is not.
TEST(Charts, MeanAreaHasALineThroughTheScalingState) {
    const RunRecord run =
        run_of({{0.0, 4000}, {2.0, 3900}, {4.0, 1000}, {12.0, 500}, {16.0, 400}, {90.0, 99}});
    const Chart chart = chart_of(run, "mean_area");
    ASSERT_EQ(chart.series.size(), 2U);
    EXPECT_EQ(chart.series[0].points.size(), 5U);
    EXPECT_EQ(chart.series[1].name, "2 + 0.5 t, R² = 1.0000");
    EXPECT_NEAR(chart.series[1].points[0].y, 4.0, 1e-12);
    EXPECT_NEAR(chart.series[1].points[1].x, 16.0, 1e-12);
    EXPECT_EQ(chart_of(run_of({{0.0, 4000}}), "mean_area").series.size(), 1U);
}

TEST(Charts, SecondMomentStandsBesideTheFroths) {
    RunRecord run = run_of({{1.0, 200}, {2.0, 90}});
    run.frames[0].foam.second_moment = 1.75;
    const Chart chart = chart_of(run, "second_moment");
    ASSERT_EQ(chart.bands.size(), 1U);
    EXPECT_NEAR(chart.bands[0].low, 1.3, 1e-15);
    EXPECT_NEAR(chart.bands[0].high, 1.5, 1e-15);
    ASSERT_EQ(chart.series[0].points.size(), 1U);
    EXPECT_EQ(chart.series[0].points[0].x, 1.0);
    EXPECT_EQ(chart.series[0].points[0].y, 1.75);
    EXPECT_EQ(chart.series.size(), 1U);
}

// (300 * 1.5 + 100 * 1.1)/400 = 1.4 in the frames with no more than a quarter of the bubbles.
TEST(Charts, SecondMomentHasItsMeanInTheScalingState) {
    RunRecord run = run_of({{0.0, 1200}, {8.0, 300}, {9.0, 100}, {10.0, 30}});
    run.frames[1].foam.second_moment = 1.5;
    run.frames[2].foam.second_moment = 1.1;
    const Chart chart = chart_of(run, "second_moment");
    ASSERT_EQ(chart.series.size(), 2U);
    EXPECT_EQ(chart.series[1].name, "mean 1.40");
    EXPECT_EQ(chart.series[1].points[0].x, 8.0);
    EXPECT_EQ(chart.series[1].points[1].x, 9.0);
    EXPECT_NEAR(chart.series[1].points[1].y, 1.4, 1e-15);
}

TEST(Charts, SidesAndPressuresHaveASeriesForEachNumberOfSides) {
    RunRecord run = run_of({{0.0, 200}, {1.0, 50}});
    run.film_tension = 2.0;
    run.frames[0].foam.mean_area = 4.0;
    run.frames[0].foam.by_sides = {{3, 50, 1.0, 0.5, 0.0}, {7, 150, 1.0, -0.25, 0.0}};
    const std::vector<Series> both = chart_of(run, "sides").series;
    ASSERT_EQ(both.size(), 2U);
    const Series& sides = both[1];
    EXPECT_EQ(sides.name, "n = 7");
    ASSERT_EQ(sides.points.size(), 1U);
    EXPECT_EQ(sides.points[0].y, 0.75);
    const Series pressures = chart_of(run, "pressures").series.at(0);
    EXPECT_EQ(pressures.points.at(0).y, 0.5 * std::sqrt(4.0) / 2.0);
}

// Of 1000 bubbles 10 are 1 %.
TEST(Charts, PressuresLeaveOutRareBubbles) {
    RunRecord run = run_of({{1.0, 1000}, {2.0, 1000}});
    run.frames[0].foam.by_sides = {{3, 9, 1.0, 20.0, 0.0}};
    run.frames[1].foam.by_sides = {{3, 10, 1.0, 20.0, 0.0}};
    EXPECT_EQ(chart_of(run, "pressures").series.at(0).points.size(), 1U);
    EXPECT_EQ(chart_of(run, "sides").series.at(0).points.size(), 2U);
}

// Two frames with 1 and 3 bubbles of seven sides: the mean of 2, 6, 6 and 6 is 5.
TEST(Charts, GrowthRatesAreMeansOverAllBubblesOfAllFrames) {
    RunRecord run = run_of({{0.0, 4}, {1.0, 4}});
    run.frames[0].growth = {{7, 1, 2.0}};
    run.frames[1].growth = {{7, 3, 6.0}};
    run.frames[0].foam.by_sides = {{7, 1, 1.0, 0.0, 200.0}};
    run.frames[1].foam.by_sides = {{7, 3, 1.0, 0.0, 600.0}};
    const Chart chart = chart_of(run, "growth_rates");
    ASSERT_EQ(chart.series.size(), 3U);
    EXPECT_NEAR(chart.series[0].points.at(0).y, run.law_rate(7), 1e-15);
    for (const std::size_t measured : {1U, 2U}) {
        EXPECT_EQ(chart.series[measured].points.at(0).x, 7.0);
        EXPECT_NEAR(chart.series[measured].points.at(0).y, 5.0, 1e-12);
    }
}

// Frame 1 apart; the record of frame 4 covers three frames.
TEST(Charts, SecondsArePerFrameBesideThePapers) {
    RunRecord run = run_of({{0.0, 40}, {1.0, 30}});
    run.frames[0].effort.seconds = 7.0;
    run.frames[1].effort.seconds = 6.0;
    run.frames[1].frame = 4;
    const Chart chart = chart_of(run, "seconds");
    ASSERT_EQ(chart.series.size(), 3U);
    EXPECT_EQ(chart.series[0].points.at(0).y, 39.5);
    EXPECT_EQ(chart.series[0].points.at(1).y, 0.084);
    ASSERT_EQ(chart.series[1].points.size(), 1U);
    EXPECT_EQ(chart.series[1].points[0].x, 30.0);
    EXPECT_EQ(chart.series[1].points[0].y, 2.0);
    EXPECT_EQ(chart.series[2].points.at(0).y, 7.0);
}

}  // namespace
}  // namespace foam::texgen
