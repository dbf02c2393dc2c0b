// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/flipbook.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

TEST(Flipbook, RejectsMissingMapsAndFrames) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto write = [&](const FlipbookOptions& options) {
        write_flipbook(set, folder.path(), options, folder.path());
    };
    EXPECT_THROW(write({.maps = {"height"}}), std::invalid_argument);
    EXPECT_THROW(write({.frames = {5}}), InputError);
    EXPECT_THROW(write({.gutter = 1, .strip = true}), std::invalid_argument);
    EXPECT_THROW(write({.columns = -1}), std::invalid_argument);
    EXPECT_EQ(folder.files().size(), 5U);  // only the files of the bake
}

// Arrays need integers of 8 or 16 bits, but ids in EXR files have 32; DDS files would be compressed
// twice.
TEST(Flipbook, SheetsThatCannotBeMadeAreRejectedBeforeTheBake) {
    const auto check = [](SheetKind sheets, const char* pattern, const char* map) {
        Preset preset;
        preset.output.sheets = sheets;
        preset.output.pattern = pattern;
        preset.image.maps = {map};
        check_sheets(preset);
    };
    for (const SheetKind sheets : {SheetKind::Dds, SheetKind::Ktx2}) {
        EXPECT_THROW(check(sheets, "{map}.####.exr", "albedo"), std::invalid_argument);
        EXPECT_THROW(check(sheets, "{map}.####.exr", "id"), std::invalid_argument);
        EXPECT_NO_THROW(check(sheets, "{map}.####.png", "albedo"));
        EXPECT_NO_THROW(check(sheets, "{map}.####.dds", "albedo"));
    }
    EXPECT_THROW(check(SheetKind::Grid, "{map}.####.dds", "albedo"), std::invalid_argument);
    EXPECT_THROW(check(SheetKind::Grid, "{map}.####.svg", "albedo"), std::invalid_argument);
    EXPECT_NO_THROW(check(SheetKind::Grid, "{map}.####.exr", "albedo"));
    EXPECT_NO_THROW(check(SheetKind::None, "{map}.####.svg", "albedo"));
    expect_rejected("bake sea_foam --set output.sheets=dds --out '{map}.####.exr'",
                    "output.sheets = \"dds\" needs PNG, DDS or KTX2 files, but output.pattern is "
                    "'{map}.####.exr'; set output.sheets to \"none\" for no sheets");
}

TEST(Flipbook, AFolderThatCannotBeWrittenIsFoundBeforeTheBake) {
    Preset preset;
    preset.output.sheet_pattern = "/dev/null/sheets/{map}";
    EXPECT_NO_THROW(check_sheet_folder(preset));  // no sheets
    preset.output.sheets = SheetKind::Grid;
    EXPECT_THROW(check_sheet_folder(preset), OutputError);
}

// The second map cannot be read.
TEST(Flipbook, SheetsFollowTheImages) {
    const auto sheets = [](const char* pattern, const char* sheet_pattern) {
        Preset preset;
        preset.output.sheets = SheetKind::Dds;
        preset.output.pattern = pattern;
        preset.output.sheet_pattern = sheet_pattern;
        return with_sheets_beside_images(preset).output.sheet_pattern;
    };
    EXPECT_EQ(sheets("out/{map}.####.png", "out/T_{map}"), "out/T_{map}");
    EXPECT_EQ(sheets("set/{map}.####.png", "out/T_{map}"), "set/T_{map}");
    EXPECT_EQ(sheets("set/{map}/a.####.png", "out/T_{map}"), "set/T_{map}");
    EXPECT_EQ(sheets("{map}.####.png", "out/T_{map}"), "T_{map}");
    EXPECT_EQ(sheets("set/{map}.####.png", "arrays/T_{map}"), "arrays/T_{map}");
}

// An explicit place of the sheets is kept.
TEST(Flipbook, OutAlsoMovesTheSheets) {
    const TemporaryFolder folder;
    const std::string base = folder.path().string();
    const std::string command =
        "bake lava --for godot -q --size 32 --set foam.bubbles=20 --set "
        "frames.count=2 --maps albedo,normal --frames 1,2 --out '" +
        base + "/{map}.####.png'";
    EXPECT_EQ(run_program(command).code, 0);
    EXPECT_TRUE(std::filesystem::exists(base + "/lava_albedo.dds"));
    EXPECT_EQ(run_program(command + " --set output.sheet_pattern=" + base + "/more/{map}").code, 0);
    EXPECT_TRUE(std::filesystem::exists(base + "/more/albedo.dds"));
}

TEST(Flipbook, AFailureLeavesNoSheet) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo", "normal"});
    std::filesystem::resize_file(folder.path() / "small_normal.0002.png", 100);
    const std::vector<std::string> before = folder.files();
    EXPECT_THROW(write_flipbook(set, folder.path(), {}, folder.path()), InputError);
    EXPECT_EQ(folder.files(), before);
}

TEST(Flipbook, RejectsFilesOfAnUnknownFormat) {
    const TemporaryFolder folder;
    BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    set.files.front().path = "small_albedo.0001.tga";
    try {
        write_flipbook(set, folder.path(), {}, folder.path());
        ADD_FAILURE() << "no failure";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("small_albedo.0001.tga': its name must end in"),
                  std::string::npos)
            << error.what();
    }
}

// Three maps of four frames are twelve units.
TEST(Flipbook, CountsEachFrameOfEachMap) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo", "height", "id"});
    std::vector<int> done;
    write_flipbook(set, folder.path(), {}, folder.path(), [&](const RunProgress& progress) {
        EXPECT_EQ(progress.phase, Phase::Sheets);
        EXPECT_EQ(progress.total, 12);
        done.push_back(progress.done);
    });
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}));
}

}  // namespace
}  // namespace foam::texgen
