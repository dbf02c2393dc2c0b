// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(StatsCommand, WritesTablesAndCharts) {
    const Outcome outcome =
        run_program("stats sea_foam --set foam.bubbles=16 --frames 1-3 --seed 5");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::string folder = "out/sea_foam_stats/";
    std::vector<std::string> names = {
        "stats.csv", "sides.csv", "stress.csv", "bubbles.csv", "events.csv", "charts.gp"};
    if (run_external({"gnuplot", "--version"})) {
        EXPECT_EQ(outcome.err, "");
        names.insert(names.end(), {"mean_area.svg", "second_moment.svg", "sides.svg"});
        names.insert(names.end(), {"pressures.svg", "growth_rates.svg", "seconds.svg"});
    } else {
        EXPECT_EQ(outcome.err,
                  "foamtex: note: charts are missing, because gnuplot is not installed; to draw "
                  "them, run in 'out/sea_foam_stats': gnuplot charts.gp\n");
    }
    std::string listed;
    for (const std::string& name : names) {
        listed += folder + name + '\n';
        EXPECT_EQ(std::count(outcome.written.begin(), outcome.written.end(), folder + name), 1)
            << name;
    }
    EXPECT_EQ(outcome.out, listed);
    EXPECT_EQ(outcome.written.size(), names.size());
}

// This PATH hides gnuplot even if it is installed.
TEST(StatsCommand, ReportsWhyThereAreNoCharts) {
    const std::string path = std::getenv("PATH");
    setenv("PATH", "/no-such-folder", 1);
    const Outcome outcome = run_program("stats sea_foam --set foam.bubbles=16 --frames 1-3");
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err,
              "foamtex: note: charts are missing, because gnuplot is not installed; to draw them, "
              "run in 'out/sea_foam_stats': gnuplot charts.gp\n");
    EXPECT_EQ(outcome.written.size(), 6U);
}

TEST(StatsCommand, TakesTheOptionsOfABakeAndAFolder) {
    const std::string small = "stats labyrinth --set foam.bubbles=16 --size 32x16 --frames 2,1 ";
    const Outcome verbose = run_program(small + "--threads 1 -v");
    EXPECT_EQ(verbose.code, 0) << verbose.err;
    // There are two lines for seeding and equilibrium, and one per frame.
    EXPECT_NE(verbose.err.find("\nframe 1: 16 bubbles, "), std::string::npos) << verbose.err;
    EXPECT_NE(verbose.err.find("\nframe 2: 16 bubbles, "), std::string::npos) << verbose.err;
    EXPECT_EQ(std::count(verbose.err.begin(), verbose.err.end(), '\n'), 2 + 2);
    const Outcome moved = run_program(small + "-q --out numbers && head -2 numbers/stats.csv");
    EXPECT_EQ(moved.out.find("frame,time,bubbles,mean_area,"), 0U);
    EXPECT_NE(moved.out.find(",seconds\n1,"), std::string::npos);
    EXPECT_EQ(run_program(small + "-q").out, "");
    expect_rejected("stats sea_foam --maps albedo",
                    "stats has no option '--maps' (see foamtex stats --help)");
    EXPECT_EQ(run_program(small + "--out /proc/self/none").code,
              static_cast<int>(ExitCode::OutputFailed));
}

}  // namespace
}  // namespace foam::texgen
