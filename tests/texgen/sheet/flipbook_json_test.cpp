// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/flipbook_json.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"
#include "texgen/sheet/flipbook.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

nlohmann::json json_of(const std::filesystem::path& path) {
    return nlohmann::json::parse(file_content(path));
}

TEST(FlipbookJson, DescribesItselfInJson) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.maps.normal.y = NormalY::Down;
    preset.maps.height.full = {0.75};
    const BakedSet set = baked(preset, {"albedo", "normal", "height"});
    write_flipbook(
        set, folder.path(), {.maps = {"normal", "height"}, .gutter = 4}, folder.path() / "sheets");
    const auto json = json_of(folder.path() / "sheets" / "small_sheet.json");
    EXPECT_EQ(json["format"], "foamtex-flipbook");
    EXPECT_EQ(json["frames"], 4);
    EXPECT_EQ(json["frames_per_second"], 24);
    EXPECT_EQ(json["tiles"], true);
    EXPECT_EQ(json["loop"]["kind"], "drift");
    EXPECT_EQ(json["loop"]["closes"], true);
    EXPECT_EQ(json["loop"]["cross_faded"], false);
    EXPECT_EQ(json["conventions"]["normal_y"], "down");
    EXPECT_EQ(json["layout"]["size"], nlohmann::json({80, 64}));
    EXPECT_EQ(json["layout"]["frame_size"], nlohmann::json({32, 24}));
    EXPECT_EQ(json["layout"]["uv"]["cell"], nlohmann::json({0.5, 0.5}));
    EXPECT_EQ(json["layout"]["uv"]["inset"], nlohmann::json({4.0 / 80.0, 4.0 / 64.0}));
    EXPECT_EQ(json["layout"]["uv"]["frame"], nlohmann::json({32.0 / 80.0, 24.0 / 64.0}));
    ASSERT_EQ(json["images"].size(), 2U);
    EXPECT_EQ(json["images"][0]["file"], "small_sheet_normal.png");
    EXPECT_EQ(json["images"][0]["color_space"], "data");
    EXPECT_EQ(json["images"][1]["type"], "uint16");
    EXPECT_EQ(json["images"][1]["range"], nlohmann::json({0.0, preset.maps.height.full.value}));
    EXPECT_EQ(json["images"][1]["displacement"], set.files.back().displacement.value_or(0.0));
    EXPECT_GT(json["images"][1]["displacement"], 0.0);
    EXPECT_FALSE(json["images"][0].contains("displacement"));
}

// Every second frame of a loop is a loop, too. The first three frames of the loop are not.
TEST(FlipbookJson, RecordsWhetherItsFramesLoop) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto closes = [&](const std::vector<int>& frames) -> bool {
        write_flipbook(set, folder.path(), {.frames = frames, .strip = true}, folder.path());
        return json_of(folder.path() / "small_strip.json")["loop"]["closes"];
    };
    EXPECT_TRUE(closes({1, 3}));
    EXPECT_TRUE(closes({4, 3, 2, 1}));
    EXPECT_FALSE(closes({1, 2, 3}));
    EXPECT_FALSE(closes({1, 2, 4, 3}));
}

// Every second frame of an animation with 24 frames per second is shown at 12 frames per second.
TEST(FlipbookJson, KeepsItsSpeed) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto rate = [&](const std::vector<int>& frames) -> double {
        write_flipbook(set, folder.path(), {.frames = frames}, folder.path());
        return json_of(folder.path() / "small_sheet.json")["frames_per_second"];
    };
    EXPECT_EQ(rate({1, 2, 3}), 24.0);
    EXPECT_EQ(rate({1, 3}), 12.0);
    EXPECT_EQ(rate({4, 1}), 8.0);
    EXPECT_EQ(rate({1, 2, 4}), 24.0);
}

}  // namespace
}  // namespace foam::texgen
