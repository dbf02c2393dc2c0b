// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_sizes.h"

#include "tests/texgen/cli/run_program.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

const std::string kSmall =
    " sea_foam --set foam.bubbles=16 --set frames.count=2 --set loop.kind=none --set "
    "output.texts=left-out ";

// Returns the number of times that a text contains a word.
int count_of(const std::string& text, const std::string& word) {
    int count = 0;
    for (std::size_t k = text.find(word); k != std::string::npos; k = text.find(word, k + 1)) {
        ++count;
    }
    return count;
}

TEST(ImageSizes, EachSizeHasAFolderAndThePixelsOfABakeOfItsOwn) {
    const TemporaryFolder work;
    const Outcome both =
        run_program("bake" + kSmall + "--size 48,24 --maps albedo,height -v", work);
    EXPECT_EQ(both.code, 0) << both.err;
    EXPECT_EQ(both.out,
              "out/48/sea_foam_albedo.####.png 1-2\nout/48/sea_foam_height.####.png 1-2\n"
              "out/24/sea_foam_albedo.####.png 1-2\nout/24/sea_foam_height.####.png 1-2\n");
    EXPECT_EQ(count_of(both.err, "first equilibrium"), 1) << both.err;
    for (const std::string size : {"48", "24"}) {
        const TemporaryFolder single;
        ASSERT_EQ(
            run_program("bake" + kSmall + "--maps albedo,height -q --size " + size, single).code,
            0);
        for (const std::string name :
             {"albedo.0001", "albedo.0002", "height.0001", "height.0002"}) {
            const std::string file = "sea_foam_" + name + ".png";
            EXPECT_TRUE(file_content(work.path() / "out" / size / file) ==
                        file_content(single.path() / "out" / file))
                << size << " " << file;
        }
        EXPECT_EQ(run_program("verify -q out/" + size, work).code, 0);
    }
}

TEST(ImageSizes, APatternWithTheSizeNeedsNoFolder) {
    const TemporaryFolder work;
    const Outcome both = run_program(
        "bake" + kSmall + "--size 48x24,24x12 --frames 1 -q --out 'out/{map}_{size}.png'", work);
    EXPECT_EQ(both.code, 0) << both.err;
    EXPECT_EQ(
        both.written,
        (std::vector<std::string>{"out/lit_24x12.png", "out/lit_48x24.png", "out/manifest.json"}));
    EXPECT_EQ(run_program("verify -q --all out", work).code, 0);
}

TEST(ImageSizes, ARenderDrawsEachSizeOfTheSameStates) {
    const TemporaryFolder work;
    ASSERT_EQ(run_program("simulate" + kSmall + "--size 32 --cache foam -q", work).code, 0);
    const Outcome both = run_program("render foam --size 48,24 --frames 1", work);
    EXPECT_EQ(both.out, "out/48/sea_foam_lit.0001.png\nout/24/sea_foam_lit.0001.png\n");
    ASSERT_EQ(
        run_program("bake" + kSmall + "--size 48,24 --frames 1 -q --out 'b/{map}.png'", work).code,
        0);
    for (const std::string size : {"48", "24"}) {
        EXPECT_TRUE(file_content(work.path() / "out" / size / "sea_foam_lit.0001.png") ==
                    file_content(work.path() / "b" / size / "lit.png"));
    }
}

TEST(ImageSizes, AResumedBakeDrawsOnlyWhatIsMissing) {
    const TemporaryFolder work;
    const std::string command = "bake" + kSmall + "--size 48,24 --json --resume ";
    ASSERT_EQ(run_program(command, work).code, 0);
    std::filesystem::remove(work.path() / "out/24/sea_foam_lit.0002.png");
    const nlohmann::json report = nlohmann::json::parse(run_program(command, work).out);
    ASSERT_EQ(report["sizes"].size(), 2U);
    EXPECT_EQ(report["status"], "complete");
    EXPECT_EQ(report["sizes"][0]["kept"], 2);
    EXPECT_EQ(report["sizes"][1]["kept"], 1);
    EXPECT_EQ(report["sizes"][1]["size"], (nlohmann::json{24, 24}));
    EXPECT_EQ(report["sizes"][1]["manifest"], "out/24/manifest.json");
    EXPECT_EQ(report["sizes"][1]["files"].size(), 2U);
    EXPECT_TRUE(std::filesystem::exists(work.path() / "out/24/sea_foam_lit.0002.png"));
}

TEST(ImageSizes, SheetsAndStatisticsDoNotCollide) {
    const TemporaryFolder work;
    const Outcome both =
        run_program("bake" + kSmall + "--size 48,24 --set output.sheets=strip --stats -q", work);
    EXPECT_EQ(both.code, 0) << both.err;
    for (const char* const name : {"out/48/sea_foam_sheet_lit.png",
                                   "out/24/sea_foam_sheet_lit.png",
                                   "out/48/sea_foam_stats/stats.csv"}) {
        EXPECT_TRUE(std::filesystem::exists(work.path() / name)) << name;
    }
    EXPECT_FALSE(std::filesystem::exists(work.path() / "out/24/sea_foam_stats"));
}

TEST(ImageSizes, ADryRunCountsTheFilesOfAllSizes) {
    const Outcome dry = run_program("bake" + kSmall + "--size 48,24 --dry-run");
    EXPECT_EQ(dry.code, 0) << dry.err;
    EXPECT_NE(dry.out.find("frames: 2 (1-2) in 2 sizes\nfiles: 4, "), std::string::npos) << dry.out;
    EXPECT_TRUE(dry.written.empty());
}

TEST(ImageSizes, RejectsSizesThatCannotShareAFoam) {
    expect_rejected("bake sea_foam --size 64,64x32",
                    "--size 64,64x32: 64x64 and 64x32 have different aspect ratios, so that they "
                    "show different foams; bake them one after the other");
    expect_rejected("bake sea_foam --size 64,32,64x64", "--size 64,32,64x64: 64x64 occurs twice");
    expect_rejected("bake sea_foam --size 64,big",
                    "--size big: key 'image.size' = [\"big\", \"big\"]: must be [width, height], "
                    "each an integer from 1 to 16384");
    expect_rejected(
        "bake sea_foam --size 64,32 --scene gltf --out 'out/{size}_{map}.####.png'",
        "--size 64,32: the scene files of 64x64 and 32x32 would have the same names; put {size} "
        "into the name of a folder in output.pattern, which is 'out/{size}_{map}.####.png'");
    EXPECT_EQ(run_program("simulate sea_foam --size 64,32 --cache foam").code, 2);
}

// The view of a patch does not depend on a torus, so its images may have any aspect ratio.
TEST(ImageSizes, APatchMayHaveSeveralAspectRatios) {
    const Outcome both =
        run_program("bake soap_raft --set foam.bubbles=12 --frames 1 --size 32,32x16 -q");
    EXPECT_EQ(both.code, 0) << both.err;
}

// Nothing is drawn if a later size is impossible.
TEST(ImageSizes, AllSizesAreCheckedBeforeTheFirstIsDrawn) {
    expect_rejected("bake sea_foam --size 64,32 --frames 1-2 --out '{size}/{map}.png'",
                    "file name pattern '{size}/{map}.png': must contain a frame number (####, "
                    "@@@@ or %04d) for 2 frames");
}

}  // namespace
}  // namespace foam::texgen
