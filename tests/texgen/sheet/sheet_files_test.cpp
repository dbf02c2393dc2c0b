// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/sheet_files.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/sheet_cells.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/png.h"
#include "texgen/sheet/flipbook.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <variant>

namespace foam::texgen {
namespace {

TEST(SheetFiles, HoldsEveryFrameOfEveryMapAsItIs) {
    const TemporaryFolder folder;
    const BakedSet set =
        baked(small_loop(folder.path()), {"albedo", "height", "normal", "motion", "id"});
    const Flipbook flipbook =
        write_flipbook(set, folder.path(), {.columns = 3, .gutter = kGutter}, folder.path());
    EXPECT_EQ(flipbook.layout, (SheetLayout{4, 32, 24, 3, kGutter}));
    ASSERT_EQ(flipbook.files.size(), 6U);
    for (const ManifestMap& map : set.maps) {
        SCOPED_TRACE(map.name);
        const Picture sheet = read_picture(folder.path() / ("small_sheet_" + map.name + ".png"));
        for (int k = 0; k < 4; ++k) {
            const Picture frame =
                read_picture(folder.path() / set.find_file(map.name, k + 1)->path);
            ASSERT_EQ(sheet.groups[0].type, frame.groups[0].type);
            std::visit(
                [&]<class Sample>(const Image<Sample>& pixels) {
                    const auto& samples = std::get<Image<Sample>>(sheet.groups[0].samples);
                    expect_cell(samples, k % 3, k / 3, pixels);
                },
                frame.groups[0].samples);
        }
    }
}

TEST(SheetFiles, KeepsTheMetadataOfFrames) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo", "normal"});
    write_flipbook(set, folder.path(), {}, folder.path());
    const ImageMetadata colors = read_picture(folder.path() / "small_sheet_albedo.png").metadata;
    const ImageMetadata data = read_picture(folder.path() / "small_sheet_normal.png").metadata;
    EXPECT_TRUE(colors.color);
    EXPECT_FALSE(data.color);
    auto expected = read_picture(folder.path() / "small_normal.0001.png").metadata.text;
    expected.emplace_back("Flipbook", "2 x 2 frames of 32 x 24, gutter 0");
    EXPECT_EQ(data.text, expected);
}

TEST(SheetFiles, HasNoMetadataIfFramesHaveNone) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path());
    preset.output.texts = FileTexts::LeftOut;
    write_flipbook(baked(preset, {"albedo"}), folder.path(), {}, folder.path());
    EXPECT_TRUE(read_picture(folder.path() / "small_sheet_albedo.png").metadata.text.empty());
}

// The gutter of a patch repeats the edge of the frame.
TEST(SheetFiles, ExtendsTheEdgeOfFramesThatDoNotTile) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_patch(folder.path()), {"normal"});
    write_flipbook(set, folder.path(), {.frames = {2}, .gutter = kGutter}, folder.path());
    const auto sheet = codes8(read_picture(folder.path() / "small_sheet_normal.png"));
    const auto frame = codes8(read_picture(folder.path() / "small_normal.0002.png"));
    for (int y = 0; y < sheet.height(); ++y) {
        for (int x = 0; x < sheet.width(); ++x) {
            const auto expected =
                frame.pixel(std::clamp(x - kGutter, 0, 31), std::clamp(y - kGutter, 0, 23));
            ASSERT_TRUE(std::ranges::equal(sheet.pixel(x, y), expected)) << x << " " << y;
        }
    }
}

TEST(SheetFiles, RejectsAFrameOfAnotherKind) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const auto write = [&] { write_flipbook(set, folder.path(), {}, folder.path()); };
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(32, 24, 4).view());
    try {
        write();
        ADD_FAILURE();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "'" + (folder.path() / "small_albedo.0002.png").string() +
                      "' has the channels R G B A (uint8), but the first frame has R G B (uint8)");
    }
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(24, 32, 3).view());
    EXPECT_THROW(write(), InputError);
    write_png(folder.path() / "small_albedo.0002.png", Image<std::uint8_t>(32, 24, 3).view());
    EXPECT_NO_THROW(write());
}

}  // namespace
}  // namespace foam::texgen
