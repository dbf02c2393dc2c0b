// SPDX-License-Identifier: Apache-2.0

#include "tests/support/test_files.h"
#include "tests/texgen/cli/run_program.h"
#include "texgen/cli/exit_code.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr const char* kSmall =
    " --threads 1 --width 32 --set foam.bubbles=12 --set loop.kind=none --set image.size=[64,64]";

const std::string kMark =
    "# Written by foamtex vary, which replaces this file the next time. Rename it to keep it.\n";

TEST(VaryCommand, WritesASheetAndPresetFiles) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(
        std::string("vary sea_foam --seeds 1-2 --sweep foam.lloyd=0,3") + kSmall, folder);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out,
              "out/sea_foam_variations.png\nout/sea_foam_1.toml\nout/sea_foam_2.toml\n"
              "out/sea_foam_3.toml\nout/sea_foam_4.toml\n");
    EXPECT_EQ(file_content(folder.path() / "out" / "sea_foam_4.toml"),
              kMark +
                  "extends = \"sea_foam\"\n"
                  "\n[foam]\nbubbles = 12\nseed = 2\nlloyd = 3\n"
                  "\n[loop]\nkind = \"none\"\n"
                  "\n[image]\nsize = [64, 64]\n");
    EXPECT_EQ(run_program("bake out/sea_foam_4.toml --frames 1 -q", folder).code, 0);
}

TEST(VaryCommand, FilesExtendThePresetWhereverItIs) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "mine.toml") << "extends = \"sea_foam\"\n";
    ASSERT_EQ(run_program(std::string("vary mine.toml --seeds 4 -q -o a/b") + kSmall, folder).code,
              0);
    EXPECT_EQ(file_content(folder.path() / "a" / "b" / "mine_1.toml").substr(kMark.size(), 33),
              "extends = \"../../mine.toml\"\n\n[foa");
    EXPECT_EQ(run_program("bake a/b/mine_1.toml --frames 1 -q", folder).code, 0);
}

// Paths on the command line are relative to the working directory, those in a preset file to the
// folder of the file.
TEST(VaryCommand, FilesNamePicturesFromTheirFolder) {
    const TemporaryFolder folder;
    write_png(folder.path() / "x.png", Image<std::uint8_t>(2, 2, 1).view());
    ASSERT_EQ(
        run_program(std::string("vary sea_foam --seeds 4 -q --set foam.density=x.png") + kSmall,
                    folder)
            .code,
        0);
    EXPECT_NE(
        file_content(folder.path() / "out" / "sea_foam_1.toml").find("density = \"../x.png\"\n"),
        std::string::npos);
    EXPECT_EQ(run_program("bake out/sea_foam_1.toml --frames 1 -q", folder).code, 0);
}

TEST(VaryCommand, ReplacesTheFilesOfAnEarlierRunButNoOthers) {
    const TemporaryFolder folder;
    const std::string command = std::string("vary sea_foam -q") + kSmall;
    ASSERT_EQ(run_program(command + " --seeds 1-10", folder).code, 0);
    ASSERT_EQ(run_program(command + " --seeds 1-2", folder).code, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "out" / "sea_foam_07.toml"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / "sea_foam_2.toml"));
    std::ofstream(folder.path() / "out" / "sea_foam_5.toml") << "extends = \"lava\"\n";
    const Outcome outcome = run_program(command + " --seeds 1-2", folder);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::OutputFailed));
    EXPECT_EQ(outcome.err,
              "foamtex: 'out/sea_foam_5.toml' would be replaced or removed, but was not written by "
              "foamtex vary\n");
}

TEST(VaryCommand, NotesKeysWithoutEffect) {
    const Outcome outcome =
        run_program(std::string("vary sea_foam --sweep vector.width_mm=30,40") + kSmall);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("note: vector.width_mm has no effect"), std::string::npos)
        << outcome.err;
}

// The picture is square, but the foam is not.
TEST(VaryCommand, NotesAStretchedPictureOnce) {
    const TemporaryFolder folder;
    write_png(folder.path() / "x.png", Image<std::uint8_t>(2, 2, 1).view());
    const Outcome outcome = run_program(std::string("vary sea_foam --seeds 4-5") + kSmall +
                                            " --set foam.density=x.png --set image.size=[64,32]",
                                        folder);
    const std::string note =
        "foamtex: note: foam.density: 'x.png' of 2 x 2 pixels is stretched to the aspect ratio of "
        "the foam, 2\n";
    const std::size_t found = outcome.err.find(note);
    ASSERT_NE(found, std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find(note, found + 1), std::string::npos) << outcome.err;
}

TEST(VaryCommand, ABadRequestIsOneLineAndWritesNothing) {
    const TemporaryFolder folder;
    const Outcome none = run_program("vary sea_foam", folder);
    EXPECT_EQ(none.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(none.err,
              "foamtex: vary needs one or two sweeps, not 0: --seeds RANGE, --sweep KEY=VALUES; "
              "or --random COUNT\n");
    const Outcome value = run_program("vary sea_foam --sweep foam.bubbles=9,2", folder);
    EXPECT_EQ(value.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_NE(value.err.find("--sweep foam.bubbles=9,2: key 'foam.bubbles' = 2"), std::string::npos)
        << value.err;
    EXPECT_EQ(run_program("vary sea_foam --seeds 1 --map nothing", folder).code,
              static_cast<int>(ExitCode::BadRequest));
    EXPECT_TRUE(value.written.empty());
}

TEST(VaryCommand, RandomVariationsAreReproducible) {
    const std::string command = std::string("vary pebbles -q --random 3") + kSmall;
    const auto content = [](const TemporaryFolder& folder, const std::string& name) {
        return file_content(folder.path() / "out" / name);
    };
    const TemporaryFolder one;
    const TemporaryFolder same;
    const TemporaryFolder other;
    ASSERT_EQ(run_program(command, one).code, 0);
    ASSERT_EQ(run_program(command + " --random-seed 1", same).code, 0);
    ASSERT_EQ(run_program(command + " --random-seed 2", other).code, 0);
    for (const char* name : {"pebbles_1.toml", "pebbles_3.toml", "pebbles_variations.png"}) {
        EXPECT_EQ(content(one, name), content(same, name)) << name;
        EXPECT_NE(content(one, name), content(other, name)) << name;
    }
    EXPECT_NE(content(one, "pebbles_2.toml").find("bubbles = 12\n"), std::string::npos);
    EXPECT_NE(content(one, "pebbles_2.toml").find("\n[albedo]\n"), std::string::npos);
}

TEST(VaryCommand, RandomVariationsNeedAList) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "mine.toml") << "[foam]\nbubbles = 20\n";
    const Outcome outcome = run_program("vary mine.toml --random 3", folder);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(outcome.err,
              "foamtex: preset 'mine' has no list of keys for --random; its key preset.vary is "
              "empty, and may be a list such as [\"foam.lloyd=0,1,4\", "
              "\"loop.amplitude=0.1..0.4\"]\n");
    EXPECT_EQ(run_program("vary mine.toml --random 3 --seeds 1-3", folder).code,
              static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(run_program("vary mine.toml --seeds 1-3 --random-seed 3", folder).code,
              static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(outcome.written, std::vector<std::string>{"mine.toml"});
}

TEST(VaryCommand, TheReportListsTheValuesOfEveryVariation) {
    const Outcome outcome =
        run_program(std::string("vary sea_foam --json --seeds 4 --sweep 'albedo.colors=#102030,"
                                "[\"#000000\", \"#ffffff\"]'") +
                    kSmall);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto report = nlohmann::json::parse(outcome.out);
    EXPECT_EQ(report["status"], "complete");
    ASSERT_EQ(report["variations"].size(), 2U);
    const auto& second = report["variations"][1];
    EXPECT_EQ(second["number"], 2);
    EXPECT_EQ(second["status"], "complete");
    EXPECT_EQ(second["file"], "out/sea_foam_2.toml");
    EXPECT_EQ(
        second["assignments"],
        nlohmann::json::parse(R"({"foam.seed": 4, "albedo.colors": ["#000000", "#ffffff"]})"));
}

TEST(VaryCommand, AFoamWithoutEquilibriumLeavesTheOthers) {
    const TemporaryFolder folder;
    const std::string command =
        "vary sea_foam --sweep loop.amplitude=0,0.9 --set foam.bubbles=40 --set loop.cycles=1 "
        "--set frames.count=6 --set image.size=[64,64] --width 32 --threads 1";
    const Outcome outcome = run_program(command, folder);
    EXPECT_EQ(outcome.code, static_cast<int>(ExitCode::NoEquilibrium)) << outcome.err;
    EXPECT_EQ(outcome.out, "out/sea_foam_variations.png\nout/sea_foam_1.toml\n");
    EXPECT_NE(outcome.err.find("variation 2 (amplitude=0.9): "), std::string::npos) << outcome.err;
    const auto report = nlohmann::json::parse(run_program(command + " --json", folder).out);
    EXPECT_EQ(report["status"], "failed");
    EXPECT_EQ(report["variations"][0]["status"], "complete");
}

}  // namespace
}  // namespace foam::texgen
