// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>

namespace foam::texgen {
namespace {

using Json = nlohmann::json;

std::string small_foam() {
    return "sea_foam --set foam.bubbles=16 --set frames.count=3 --size 16 ";
}

/// Returns the JSON object on stdout. Expects that it is one line, and that stderr is empty.
Json object_of(const Outcome& outcome) {
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1);
    return Json::parse(outcome.out);
}

TEST(JsonReport, OfABakeListsTheFiles) {
    const TemporaryFolder work;
    const Json baked = object_of(run_program("bake " + small_foam() + "--frames 1-2 --json", work));
    EXPECT_EQ(baked["status"], "complete");
    EXPECT_EQ(baked["preset"], "sea_foam");
    EXPECT_EQ(baked["frames"], "1-2");
    EXPECT_EQ(baked["kept"], 0);
    EXPECT_EQ(baked["manifest"], "out/manifest.json");
    EXPECT_LT(baked["closing_error"], 1e-9);
    EXPECT_EQ(baked["relaxations"], 0);
    EXPECT_EQ(baked["files"], (Json{"out/sea_foam_lit.0001.png", "out/sea_foam_lit.0002.png"}));
    const Json resumed = object_of(run_program("bake " + small_foam() + "--resume --json", work));
    EXPECT_EQ(resumed["kept"], 2);
    EXPECT_EQ(resumed["files"].size(), 3U);
    const Json idle = object_of(run_program("bake " + small_foam() + "--resume --json", work));
    EXPECT_EQ(idle["kept"], 3);
    EXPECT_EQ(idle["closing_error"], baked["closing_error"]);
}

TEST(JsonReport, DescribesCachesRendersAndStatistics) {
    const TemporaryFolder work;
    const Json simulated =
        object_of(run_program("simulate " + small_foam() + "--cache c --json", work));
    EXPECT_EQ(simulated["cache"], "c");
    EXPECT_EQ(simulated["status"], "complete");
    const Json rendered = object_of(run_program("render c --frames 2 --json", work));
    EXPECT_EQ(rendered["files"].size(), 1U);
    const Json measured = object_of(run_program("stats c --json", work));
    EXPECT_GE(measured["files"].size(), 3U);  // two tables, a script, and with gnuplot also charts
}

TEST(JsonReport, OfAComparisonListsEveryImage) {
    const TemporaryFolder work;
    ASSERT_EQ(run_program("bake " + small_foam() + "-q", work).code, 0);
    const std::string pattern = "out/sea_foam_lit.####.png ";
    const Json same =
        object_of(run_program("compare " + pattern + pattern + "--frames 1-3 --json", work));
    EXPECT_EQ(same["status"], "same");
    EXPECT_EQ(same["images"].size(), 3U);
    const Outcome other =
        run_program("compare out/sea_foam_lit.0001.png out/sea_foam_lit.0002.png --json", work);
    EXPECT_EQ(other.code, 2);
    EXPECT_EQ(object_of(other)["images"][0]["verdict"], "failure");
    EXPECT_GT(object_of(other)["images"][0]["largest"], 0.0);
}

TEST(JsonReport, DescribesFlipbooksAndPreviews) {
    const TemporaryFolder work;
    ASSERT_EQ(run_program("bake " + small_foam() + "--maps albedo,film -q", work).code, 0);
    const Json flipbook = object_of(run_program("flipbook out --json", work));
    EXPECT_EQ(flipbook,
              (Json{{"status", "complete"},
                    {"preset", "sea_foam"},
                    {"frames", "1-3"},
                    {"layout", "out/sea_foam_sheet.json"},
                    {"files", {"out/sea_foam_sheet_albedo.png", "out/sea_foam_sheet_film.png"}}}));
    const Json shown = object_of(run_program("preview out --as loop --frames 2,1 --json", work));
    EXPECT_EQ(shown,
              (Json{{"status", "complete"},
                    {"preset", "sea_foam"},
                    {"frames", "2-1"},
                    {"files", {"out/sea_foam_albedo_loop.png"}}}));
    const Json baked =
        object_of(run_program("preview " + small_foam() + "--as tiling --json", work));
    EXPECT_EQ(baked["frames"], "1-3");
    EXPECT_EQ(baked["files"], Json{"out/sea_foam_lit_tiling.png"});
    EXPECT_LT(baked["closing_error"], 1e-9);
}

TEST(JsonReport, OfAFailureNamesTheError) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=40 --set loop.amplitude=0.9 --set loop.cycles=1 "
        "--set frames.count=6 --size 16 --json");
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::NoEquilibrium));
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1);
    const Json report = Json::parse(outcome.out);
    EXPECT_NE(report["status"], "complete");
    EXPECT_EQ(report["failed_frame"], 1);
    EXPECT_TRUE(report["files"].empty());
}

}  // namespace
}  // namespace foam::texgen
