// SPDX-License-Identifier: Apache-2.0

#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/png.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace foam::texgen {
namespace {

void bake(const TemporaryFolder& folder, const std::string& more = "") {
    const Outcome outcome = run_program(
        "bake sea_foam -q --threads 1 --size 48x32 --frames 1-3 --set foam.bubbles=12 "
        "--set loop.kind=none " +
            more,
        folder);
    ASSERT_EQ(outcome.code, 0) << outcome.err;
}

TEST(FlipbookCommand, NamesItsFiles) {
    const TemporaryFolder folder;
    bake(folder, "--maps albedo,height");
    const Outcome outcome = run_program("flipbook out", folder);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(outcome.out,
              "out/sea_foam_sheet_albedo.png\nout/sea_foam_sheet_height.png\n"
              "out/sea_foam_sheet.json\n");
    EXPECT_EQ(run_program("flipbook out --strip -q --maps height --out strips", folder).out, "");
    const Picture strip = read_picture(folder.path() / "strips" / "sea_foam_strip_height.png");
    EXPECT_EQ(strip.width(), 48);
    EXPECT_EQ(strip.height(), 3 * 32);
}

TEST(FlipbookCommand, KeepsSheetsOfOtherMapsOfTheSameFrames) {
    const TemporaryFolder folder;
    bake(folder, "--maps albedo,height");
    ASSERT_EQ(run_program("flipbook out --maps albedo", folder).err, "");
    ASSERT_EQ(run_program("flipbook out --maps height", folder).err, "");
    const std::string both = file_content(folder.path() / "out" / "sea_foam_sheet.json");
    EXPECT_NE(both.find("sea_foam_sheet_albedo.png"), std::string::npos);
    EXPECT_EQ(run_program("flipbook out --maps height --frames 1-2", folder).err,
              "foamtex: note: 'out/sea_foam_sheet.json' no longer lists sea_foam_sheet_albedo.png: "
              "these sheets have another layout or other frames, or were made from another bake\n");
}

TEST(FlipbookCommand, WarnsOfSizesThatHardwareDoesNotSupport) {
    const TemporaryFolder folder;
    bake(folder);
    const Outcome outcome =
        run_program("flipbook out --columns 3 --gutter 1024 --frames 3-1", folder);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    const Outcome large = run_program("flipbook out --columns 16 --gutter 1000 -q", folder);
    EXPECT_EQ(large.code, 0);
    EXPECT_EQ(
        large.err,
        "foamtex: warning: the sheet is 32768 x 2032 pixels; graphics hardware usually supports "
        "at most 16384 per side\n");
}

TEST(FlipbookCommand, ABadRequestIsOneLine) {
    const TemporaryFolder folder;
    const Outcome nothing = run_program("flipbook .", folder);
    EXPECT_EQ(nothing.code, static_cast<int>(ExitCode::BadInput));
    bake(folder);
    const Outcome map = run_program("flipbook out --maps normal", folder);
    EXPECT_EQ(map.code, static_cast<int>(ExitCode::BadRequest));
    EXPECT_EQ(map.err, "foamtex: map 'normal' was not baked; baked maps: lit\n");
    const Outcome frame = run_program("flipbook out --frames 3-4", folder);
    EXPECT_EQ(frame.code, static_cast<int>(ExitCode::BadInput));
    EXPECT_EQ(frame.err,
              "foamtex: frame 4 of map 'lit' of preset 'sea_foam' was not baked into 'out', or "
              "another bake has replaced it; existing frames: 1-3\n");
    const Outcome strip = run_program("flipbook out --strip --gutter 2", folder);
    EXPECT_EQ(strip.code, static_cast<int>(ExitCode::BadRequest));
}

// ImageMagick's virtual pixels continue a frame periodically. The distortion only adds these pixels
// around the frame, as in a cell with a gutter.
TEST(FlipbookCommand, ImageMagickContinuesFramesAsOurGuttersDo) {
    if (std::system("command -v convert compare >/dev/null") != 0) {
        GTEST_SKIP() << "there is no ImageMagick";
    }
    const TemporaryFolder folder;
    bake(folder, "--maps albedo,height");
    ASSERT_EQ(run_program("flipbook out --columns 2 --gutter 5", folder).code, 0);
    for (const std::string map : {"albedo", "height"}) {
        const std::string script = fmt::format(
            "cd {}/out && convert sea_foam_{}.0003.png -virtual-pixel tile -filter point "
            "-set option:distort:viewport 58x42-5-5 -distort SRT 0 +repage expected.png && "
            "convert sea_foam_sheet_{}.png -crop 58x42+0+42 +repage cell.png && "
            "compare -metric AE expected.png cell.png null: 2>differing",
            folder.path().string(),
            map,
            map);
        EXPECT_EQ(std::system(script.c_str()), 0);
        EXPECT_EQ(file_content(folder.path() / "out" / "differing"), "0") << map;
    }
}

}  // namespace
}  // namespace foam::texgen
