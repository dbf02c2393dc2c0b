// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"
#include "texgen/json/json_writer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

std::string small_foam() {
    return "sea_foam --set foam.bubbles=16 --set frames.count=4 --size 32x16";
}

class RenderCommand : public testing::Test {
  protected:
    void SetUp() override {
        ASSERT_EQ(run("simulate " + small_foam() + " --cache foam").out, "foam\n");
    }

    Outcome run(const std::string& arguments) { return run_program(arguments, work_); }

    std::string content(const std::string& name) { return file_content(work_.path() / name); }

    void expect_rejected(const std::string& arguments, ExitCode code, const std::string& line) {
        const Outcome outcome = run("render " + arguments);
        EXPECT_EQ(outcome.code, static_cast<int>(code));
        EXPECT_EQ(outcome.err, "foamtex: " + line + "\n");
        EXPECT_EQ(outcome.out, "");
        EXPECT_FALSE(std::filesystem::exists(work_.path() / "out"));
    }

    TemporaryFolder work_;
};

// The frames are rendered in two parts, as on two machines.
TEST_F(RenderCommand, DrawsTheSameAsABake) {
    ASSERT_EQ(run("bake " + small_foam() + " --maps albedo,motion -q").code, 0);
    std::filesystem::rename(work_.path() / "out", work_.path() / "baked");
    for (const char* frames : {"3-4", "1-2"}) {
        const Outcome part =
            run(std::string("render foam --maps albedo,motion -q --frames ") + frames);
        EXPECT_EQ(part.code, 0) << part.err;
    }
    for (const char* map : {"albedo", "motion"}) {
        for (const char* frame : {"1", "2", "3", "4"}) {
            const std::string name = std::string("/sea_foam_") + map + ".000" + frame + ".png";
            EXPECT_FALSE(content("baked" + name).empty());
            EXPECT_TRUE(content("out" + name) == content("baked" + name)) << name;
        }
    }
    EXPECT_EQ(run("verify out -q").code, 0);
}

TEST_F(RenderCommand, TakesTheCachedFramesAndDrawingOptions) {
    const Outcome outcome = run("render foam --size 64x32 --maps normal --normal-y dx");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "out/sea_foam_normal.####.png 1-4\n");
}

TEST_F(RenderCommand, OptionThatChangesTheFoamIsOneLineAndCode2) {
    expect_rejected("foam --set foam.seed=5",
                    ExitCode::BadRequest,
                    "key 'foam.seed' = 5: must be 1, as in the cache; with a cache, only "
                    "preset.description, preset.vary and keys of images, output, drawings, meshes "
                    "and maps can be changed; for a patch without events at positions, also the "
                    "camera");
    expect_rejected("foam --size 32",
                    ExitCode::BadRequest,
                    "key 'image.size' = [32, 32]: must have the aspect ratio 2:1 of the cache, "
                    "such as [32, 16]");
}

TEST_F(RenderCommand, MissingFrameIsOneLineAndCode4) {
    expect_rejected(
        "foam --frames 9",
        ExitCode::BadInput,
        "the cache 'foam' has no state 9; only frames 1-4 can be drawn, and only after 'foamtex "
        "simulate' has written their states");
    expect_rejected(
        "none", ExitCode::BadInput, "cannot read 'none/cache.json': No such file or directory");
}

TEST_F(RenderCommand, NotesACacheOfAnotherVersion) {
    Json cache = Json::parse(content("foam/cache.json"));
    EXPECT_EQ(cache["foamtex"], FOAMTEX_VERSION);
    EXPECT_EQ(run("render foam --frames 1").err, "");
    cache["foamtex"] = "0.0.1";
    std::ofstream(work_.path() / "foam" / "cache.json") << cache;
    const Outcome noted = run("render foam --frames 1");
    EXPECT_EQ(noted.code, 0);
    const std::string note =
        "foamtex: note: the cache 'foam' was simulated by foamtex 0.0.1; this is "
        "foamtex " FOAMTEX_VERSION ", which may simulate the same preset differently\n";
    EXPECT_EQ(noted.err, note);
    EXPECT_EQ(run("render foam --frames 1 -q").err, "");
    EXPECT_EQ(run("stats foam").err.find(note), 0U);
    EXPECT_EQ(run("stats foam -q").err, "");
}

TEST_F(RenderCommand, ACacheHasStatistics) {
    ASSERT_EQ(run("stats " + small_foam() + " --out a -q").code, 0);
    const Outcome cached = run("stats foam --out b -q");
    ASSERT_EQ(cached.code, 0) << cached.err;
    EXPECT_FALSE(content("a/sides.csv").empty());
    EXPECT_EQ(content("a/sides.csv"), content("b/sides.csv"));
}

// T1s, T2s and events between the requested frames count, although no frame needs their states.
TEST_F(RenderCommand, StatisticsOfACacheCountTheEventsOfSkippedStates) {
    const std::string foam = "coarsening --size 64 --set foam.bubbles=100 --set frames.count=8 ";
    ASSERT_EQ(run("simulate " + foam + "--cache foam8").code, 0);
    ASSERT_EQ(run("stats " + foam + "--frames 2,7 --out a -q").code, 0);
    ASSERT_EQ(run("stats foam8 --frames 2,7 --out b -q").code, 0);
    EXPECT_GT(std::ranges::count(content("a/events.csv"), '\n'), 1);
    EXPECT_EQ(content("a/events.csv"), content("b/events.csv"));
    ASSERT_EQ(run("render foam8 --frames 2,7 --stats --out 'c/{map}.####.png' -q").code, 0);
    EXPECT_EQ(content("a/events.csv"), content("c/coarsening_stats/events.csv"));
    // A second simulation of fewer frames leaves the states of the other frames in the folder.
    ASSERT_EQ(run("simulate " + foam + "--frames 2,7 --cache foam8").code, 0);
    ASSERT_EQ(run("stats foam8 --out d -q").code, 0);
    EXPECT_EQ(content("a/events.csv"), content("d/events.csv"));
}

// The ranges are fitted by `simulate`, and again by the first `render` of another surface.
TEST_F(RenderCommand, FitsRangesOnlyIfTheyAreNotStored) {
    const auto fits_ranges = [&](const std::string& arguments) {
        const Outcome outcome = run(arguments + " --progress json");
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.err.find(R"("phase":"ranges")") != std::string::npos;
    };
    EXPECT_TRUE(
        fits_ranges("simulate pebbles --set foam.bubbles=16 --set frames.count=4 "
                    "--size 32 --cache stones"));
    const std::string render = "render stones --maps height --out '{map}.####.png'";
    EXPECT_FALSE(fits_ranges(render));
    EXPECT_TRUE(fits_ranges(render + " --set relief.width=0.4"));
    EXPECT_FALSE(fits_ranges(render + " --set relief.width=0.4"));
}

}  // namespace
}  // namespace foam::texgen
