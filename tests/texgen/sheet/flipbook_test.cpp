#include "texgen/sheet/flipbook.h"

#include "tests/texgen/cli/run_program.h"
#include "tests/texgen/sheet/small_bake.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/exr.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kGutter = 3;

/// Every sample of a cell, gutter and all, against the frame that goes on as a tile.
template <class Sample>
void expect_cell(const Image<Sample>& sheet, int column, int row, const Image<Sample>& frame) {
    const int left = column * (frame.width() + 2 * kGutter);
    const int bottom = sheet.height() - (row + 1) * (frame.height() + 2 * kGutter);
    for (int y = 0; y < frame.height() + 2 * kGutter; ++y) {
        for (int x = 0; x < frame.width() + 2 * kGutter; ++x) {
            const auto expected = frame.pixel((x - kGutter + frame.width()) % frame.width(),
                                              (y - kGutter + frame.height()) % frame.height());
            ASSERT_TRUE(std::ranges::equal(sheet.pixel(left + x, bottom + y), expected))
                << column << " " << row << ": " << x << " " << y;
        }
    }
}

TEST(Flipbook, HoldsEveryFrameOfEveryMapAsItIs) {
    const TemporaryFolder folder;
    const BakedSet set =
        baked(small_loop(folder.path()), {"albedo", "height", "normal", "motion", "id"});
    const Flipbook flipbook =
        write_flipbook(set, folder.path(), {.columns = 3, .gutter = kGutter}, folder.path());
    EXPECT_EQ(flipbook.layout, (SheetLayout{4, 32, 24, 3, kGutter}));
    ASSERT_EQ(flipbook.files.size(), 6U);
    for (const ManifestMap& map : set.maps) {
        SCOPED_TRACE(map.name);
        const PngSamples sheet =
            read_png_samples(folder.path() / ("small_sheet_" + map.name + ".png"));
        for (int k = 0; k < 4; ++k) {
            const PngSamples frame =
                read_png_samples(folder.path() / set.find_file(map.name, k + 1)->path);
            ASSERT_EQ(sheet.index(), frame.index());
            std::visit(
                [&]<class Sample>(const Image<Sample>& pixels) {
                    expect_cell(std::get<Image<Sample>>(sheet), k % 3, k / 3, pixels);
                },
                frame);
        }
    }
}

TEST(Flipbook, KeepsWhatAFileSaysOfItself) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo", "normal"});
    write_flipbook(set, folder.path(), {}, folder.path());
    const PngMetadata colors = read_png(folder.path() / "small_sheet_albedo.png").metadata;
    const PngMetadata data = read_png(folder.path() / "small_sheet_normal.png").metadata;
    EXPECT_TRUE(colors.color);
    EXPECT_FALSE(data.color);
    auto expected = read_png(folder.path() / "small_normal.0001.png").metadata.text;
    expected.emplace_back("Flipbook", "2 x 2 frames of 32 x 24, gutter 0");
    EXPECT_EQ(data.text, expected);
}

TEST(Flipbook, SaysNothingWhereFramesDoNot) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.output.texts = FileTexts::LeftOut;
    write_flipbook(baked(preset, {"albedo"}), folder.path(), {}, folder.path());
    EXPECT_TRUE(read_png(folder.path() / "small_sheet_albedo.png").metadata.text.empty());
}

// The frames of a patch end where their image does.
TEST(Flipbook, ExtendsTheEdgeOfWhatDoesNotTile) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_patch(folder.path()), {"normal"});
    write_flipbook(set, folder.path(), {.frames = {2}, .gutter = kGutter}, folder.path());
    const auto sheet = read_png(folder.path() / "small_sheet_normal.png").pixels;
    const auto frame = read_png(folder.path() / "small_normal.0002.png").pixels;
    for (int y = 0; y < sheet.height(); ++y) {
        for (int x = 0; x < sheet.width(); ++x) {
            const auto expected =
                frame.pixel(std::clamp(x - kGutter, 0, 31), std::clamp(y - kGutter, 0, 23));
            ASSERT_TRUE(std::ranges::equal(sheet.pixel(x, y), expected)) << x << " " << y;
        }
    }
}

TEST(Flipbook, JoinsALayerOfExrs) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.output.pattern = (folder.path() / "small.####.exr").string();
    const BakedSet set = baked(preset, {"albedo", "height", "id"});
    write_flipbook(set, folder.path(), {.columns = 3, .gutter = kGutter}, folder.path());
    const ExrImage frame = read_exr(folder.path() / "small.0004.exr");
    std::size_t compared = 0;
    for (const ExrPlane& plane : frame.channels) {
        const std::size_t dot = plane.name.find('.');
        const ExrImage sheet =
            read_exr(folder.path() / ("small_sheet_" + plane.name.substr(0, dot) + ".exr"));
        EXPECT_EQ(sheet.metadata.frame_rate, (FrameRate{24, 1}));
        const auto same =
            std::ranges::find(sheet.channels, plane.name.substr(dot + 1), &ExrPlane::name);
        ASSERT_NE(same, sheet.channels.end()) << plane.name;
        EXPECT_EQ(same->type, plane.type);
        std::visit(
            [&]<class Sample>(const Image<Sample>& pixels) {
                expect_cell(std::get<Image<Sample>>(same->pixels), 0, 1, pixels);
            },
            plane.pixels);
        ++compared;
    }
    EXPECT_EQ(compared, 5U);  // R, G, B of albedo, and a channel each of the others
}

nlohmann::json json_of(const std::filesystem::path& path) {
    return nlohmann::json::parse(file_content(path));
}

TEST(Flipbook, DescribesItselfInJson) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.maps.normal.y = NormalY::Down;
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
    EXPECT_EQ(json["images"][1]["range"], nlohmann::json({0.0, preset.maps.height.full}));
}

// Every second frame of a loop is a loop; its first three are not.
TEST(Flipbook, KnowsWhetherItsFramesClose) {
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

// Every second of 24 frames a second makes 12.
TEST(Flipbook, KeepsItsSpeed) {
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

TEST(Flipbook, RefusesWhatIsNotThere) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto write = [&](const FlipbookOptions& options) {
        write_flipbook(set, folder.path(), options, folder.path());
    };
    EXPECT_THROW(write({.maps = {"height"}}), std::invalid_argument);
    EXPECT_THROW(write({.frames = {5}}), InputError);
    EXPECT_THROW(write({.gutter = 1, .strip = true}), std::invalid_argument);
    EXPECT_THROW(write({.columns = -1}), std::invalid_argument);
    EXPECT_EQ(folder.files().size(), 5U);  // of the bake
}

TEST(Flipbook, RefusesAFrameOfAnotherKind) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto write = [&] { write_flipbook(set, folder.path(), {}, folder.path()); };
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(32, 24, 4).view());
    EXPECT_THROW(write(), InputError);
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(24, 32, 3).view());
    EXPECT_THROW(write(), InputError);
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(32, 24, 3).view());
    EXPECT_NO_THROW(write());
}

}  // namespace
}  // namespace foam::texgen
