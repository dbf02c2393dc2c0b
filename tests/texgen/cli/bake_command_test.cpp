// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/image/external_program.h"
#include "texgen/maps/map.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(BakeCommand, BakesTheFramesAskedFor) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --set frames.count=4 --frames 3-1x2 --size 16x8 "
        "--threads 1");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");  // no progress bar, because stderr is not a terminal
    EXPECT_EQ(outcome.out, "out/sea_foam_lit.####.png 3,1\n");
    EXPECT_EQ(outcome.written,
              (std::vector<std::string>{
                  "out/manifest.json", "out/sea_foam_lit.0001.png", "out/sea_foam_lit.0003.png"}));
}

TEST(BakeCommand, ADryRunWritesNothing) {
    const TemporaryFolder folder;
    const std::string command =
        "bake sea_foam --dry-run --size 32 --frames 1-4 --set foam.bubbles=30";
    const Outcome text = run_program(command, folder);
    EXPECT_EQ(text.code, 0) << text.err;
    EXPECT_TRUE(text.out.starts_with("frames: 4 (1-4)\nfiles: 4, ")) << text.out;
    EXPECT_TRUE(text.written.empty());
    EXPECT_EQ(run_program(command + " -q", folder).out, "");
    const Outcome json = run_program(command + " --json", folder);
    EXPECT_NE(json.out.find("\"files\":4,"), std::string::npos) << json.out;
}

TEST(BakeCommand, PacksChannels) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1 --size 16 --maps albedo "
        "--pack ORM=occlusion,roughness,metallic --pack R=1-roughness,0,0");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "out/sea_foam_albedo.0001.png\nout/sea_foam_ORM.0001.png\nout/sea_foam_R.0001.png\n");
    expect_rejected("bake sea_foam --pack ORM=occlusion,roughness",
                    "--pack ORM=occlusion,roughness: key 'output.pack' = "
                    "[\"ORM=occlusion,roughness\"]: must be a list of packings NAME=R,G,B or "
                    "NAME=R,G,B,A, such as \"ORM=occlusion,roughness,metallic\"; packing 'ORM': "
                    "has 2 channels instead of 3 or 4: R, G, B and A");
    expect_rejected("bake sea_foam --pack A=0,0,0 --pack A=0,0,1",
                    "two images would have the word 'A' in their file names; see output.pack and "
                    "output.names");
}

TEST(BakeCommand, WritesSceneFiles) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1 --size 16 --maps albedo --out o/x.png "
        "--scene usda,gltf");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "o/x.png\no/sea_foam.usda\no/sea_foam.glb\n");
    EXPECT_EQ(outcome.written.size(), 4U);
    const Outcome json =
        run_program("bake sea_foam --set foam.bubbles=16 --frames 1 --size 16 --scene mtlx --json");
    EXPECT_NE(json.out.find("\"scenes\":[\"out/sea_foam.mtlx\"]"), std::string::npos) << json.out;
    expect_rejected("bake sea_foam --scene usd",
                    "--scene usd: key 'output.scene' = [\"usd\"]: must be a list, without "
                    "duplicates, of \"usda\", \"mtlx\", \"gltf\", or []; did you mean 'usda'?");
    expect_rejected("bake sea_foam --scene usda --out x.####.dds",
                    "output.scene = \"usda\" needs PNG files, or EXR files with {map} in their "
                    "names, but output.pattern is 'x.####.dds'; a scene of the format gltf is "
                    "possible");
}

TEST(BakeCommand, WarnsOfClippedHeightsOfAPacking) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1 --size 16 --maps albedo "
        "--pack H=height,0,0 --set height.full=0.01");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(outcome.err.starts_with("foamtex: warning: H: in a file, up to ")) << outcome.err;
    EXPECT_NE(outcome.err.find("outside of 0 to 1 and were clipped"), std::string::npos);
    EXPECT_NE(outcome.err.find("; raise height.full\n"), std::string::npos) << outcome.err;
}

TEST(BakeCommand, BakesAndMeasuresAPatch) {
    const std::string patch =
        " soap_raft --set foam.bubbles=16 --set foam.outline='POLYGON((0 0, 3 0, 3 1, 0 1))'"
        " --set camera.zoom=2 --frames 1-2 --size 24x16";
    const Outcome baked = run_program("bake" + patch);
    EXPECT_EQ(baked.code, 0) << baked.err;
    EXPECT_EQ(baked.written.size(), 2U + 1U);
    const Outcome measured = run_program("stats" + patch);
    EXPECT_EQ(measured.code, 0) << measured.err;
    EXPECT_GE(measured.written.size(), 3U);
    expect_rejected("bake soap_raft --set foam.outline=egg",
                    "--set foam.outline=egg: key 'foam.outline' = \"egg\": must be \"disc\", "
                    "\"rectangle\", a WKT polygon without self-intersections, such as "
                    "\"POLYGON((0 0, 6 0, 6 4), (3 1, 5 1, 5 2))\", or the path of a drawing or a "
                    "picture, which ends in .svg, .png, .exr, .dds or .ktx2; this is not written "
                    "as a WKT polygon; check its brackets, commas and numbers");
    expect_rejected("bake soap_raft --set 'foam.outline=POLYGON((0 0, 1 1, 1 0, 0 1))'",
                    "--set foam.outline=POLYGON((0 0, 1 1, 1 0, 0 1)): key 'foam.outline' = "
                    "\"POLYGON((0 0, 1 1, 1 0, 0 1))\": must be \"disc\", \"rectangle\", a WKT "
                    "polygon without self-intersections, such as \"POLYGON((0 0, 6 0, 6 4), (3 1, "
                    "5 1, 5 2))\", or the path of a drawing or a picture, which ends in .svg, "
                    ".png, .exr, .dds or .ktx2; the polygon crosses or touches itself");
}

TEST(BakeCommand, QuietPrintsNothingAndVerboseALinePerFrame) {
    const std::string small = "bake sea_foam --set foam.bubbles=16 --frames 1 --size 8 --out a.png";
    const Outcome quiet = run_program(small + " -q");
    EXPECT_EQ(quiet.code, 0);
    EXPECT_EQ(quiet.out + quiet.err, "");
    const Outcome verbose = run_program(small + " -v");
    EXPECT_EQ(verbose.out, "a.png\n");
    EXPECT_EQ(verbose.err.find("placing the bubbles, "), 0U) << verbose.err;
    EXPECT_NE(verbose.err.find("\nclosing the loop: cycle 1 (48/48), "), std::string::npos);
    EXPECT_NE(verbose.err.find("\nframe 1: 16 bubbles, "), std::string::npos) << verbose.err;
    EXPECT_EQ(verbose.err.find("\nframe 2: "), std::string::npos);
}

TEST(BakeCommand, NotesFramesThatDoNotLoop) {
    const std::string small =
        " --set foam.bubbles=16 --set frames.count=4 --size 8 --out a.####.png";
    const Outcome part = run_program("bake sea_foam --frames 1-3" + small);
    EXPECT_EQ(part.code, 0);
    EXPECT_EQ(part.err,
              "foamtex: note: the frames 1-3 alone do not loop; the loop of 'sea_foam' has the "
              "frames 1-4, and --set frames.count=N changes its length\n");
    EXPECT_EQ(run_program("bake sea_foam -q --frames 1-3" + small).err, "");
    EXPECT_EQ(run_program("bake sea_foam --frames 1-4" + small).err, "");
    EXPECT_EQ(run_program("bake sea_foam --set loop.kind=none --frames 1-3" + small).err, "");
}

// With "auto" no sample is clipped, whichever frames are baked. A fixed range may clip.
TEST(BakeCommand, WarnsOfClippedSamples) {
    const std::string small =
        "bake sea_foam --maps height --set foam.bubbles=16 --set frames.count=4 --frames 2 "
        "--size 64 --out a.####.png ";
    EXPECT_EQ(run_program(small).err.find("clipped"), std::string::npos);
    const std::string loud =
        "bake sea_foam --maps height --set foam.bubbles=16 --set loop.kind=none "
        "--frames 1 --size 64 --out a.####.png --set height.full=";
    EXPECT_EQ(run_program(loud + "auto").err, "");
    const Outcome clipped = run_program(loud + "0.001");
    EXPECT_EQ(clipped.code, 0);
    EXPECT_TRUE(clipped.err.starts_with("foamtex: warning: height: in a file, up to "))
        << clipped.err;
    EXPECT_TRUE(clipped.err.ends_with("; raise height.full\n")) << clipped.err;
}

TEST(BakeCommand, NotesEventsThatNeverHappen) {
    const std::string toml =
        "[[event]]\nkind = 'collapse'\nframe = 2\nbubble = 3\n"
        "[[event]]\nkind = 'collapse'\nframe = 9\nbubble = 5\n";
    const auto baked = [&](const std::string& options) {
        return run_program("--version > /dev/null && printf \"" + toml + "\" > e.toml && '" +
                           foam::test::executable().string() +
                           "' bake e.toml --set foam.bubbles=16 --size 8 --out a.####.png " +
                           options);
    };
    const Outcome late = baked("--set frames.count=4");
    EXPECT_EQ(late.code, 0);
    EXPECT_EQ(
        late.err,
        "foamtex: warning: events of 'e' never happen, because they begin after the last frame, "
        "4: event[2] begins at frame 9; raise frames.count\n");
    EXPECT_EQ(baked("--set frames.count=9 --frames 1").err, "");
}

TEST(BakeCommand, StatisticsThatCannotBeWrittenAreFoundBeforeTheBake) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "sea_foam_stats") << "a file";
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1-2 --size 8 --out '####.png' --stats",
        folder);
    EXPECT_EQ(outcome.code, 5);
    EXPECT_NE(outcome.err.find("sea_foam_stats"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.written, (std::vector<std::string>{"sea_foam_stats"}));
}

TEST(BakeCommand, ABakeWritesItsStatisticsBesideTheImages) {
    const Outcome outcome = run_program(
        "bake sea_foam --set foam.bubbles=16 --frames 1-2 --size 8 --out a/####.png --stats");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("a/####.png 1-2\na/sea_foam_stats/stats.csv\n"), 0U);
    EXPECT_GE(outcome.written.size(), 2U + 1U + 6U);
    EXPECT_EQ(outcome.written.back(), "a/sea_foam_stats/stress.csv");
}

}  // namespace
}  // namespace foam::texgen
