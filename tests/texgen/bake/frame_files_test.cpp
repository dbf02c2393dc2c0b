// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/frame_files.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/bake/baked_files.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/bake.h"
#include "texgen/image/exr.h"
#include "texgen/image/primaries.h"
#include "texgen/maps/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

std::vector<std::string> channel_names(const Picture& image) {
    std::vector<std::string> names;
    for (const ChannelGroup& group : image.groups) {
        names.push_back(group.names.front());
    }
    return names;
}

// If the file pattern has no {map}, all maps are layers of one EXR, in the order of their names.
TEST(Tiles, ATorusWhoseShearIsAMultipleOfItsWidthTiles) {
    const Domain torus{3.0, 2.0};
    for (const double shear : {0.0, 3.0 - 4e-16, -6.0 + 1e-15}) {
        EXPECT_TRUE(tiles({torus.width, torus.height, shear})) << shear;
    }
    EXPECT_FALSE(tiles({torus.width, torus.height, 1e-6}));
    EXPECT_FALSE(tiles({torus.width, torus.height, 1.5}));
    EXPECT_FALSE(tiles({0.0, 0.0, 0.0}));  // the plane
}

TEST(FrameFiles, AnExrHoldsAllMapsOfAFrame) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film", "albedo"};
    preset.output.pattern = (folder.path() / "layers.####.exr").string();
    preset.output.frames_per_second = 30;
    const BakeSummary summary = bake(preset, {.frames = {1, 2}, .threads = 2}, {});
    ASSERT_EQ(summary.files.size(), 2U);
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"layers.0001.exr", "layers.0002.exr"}));
    const Picture image = read_picture(summary.files[1]);
    EXPECT_EQ(channel_names(image),
              (std::vector<std::string>{"albedo.B", "albedo.G", "albedo.R", "film.Y"}));
    EXPECT_TRUE(image.metadata.periodic);
    EXPECT_TRUE(image.metadata.color);
    EXPECT_EQ(image.metadata.frame_rate, (FrameRate{30, 1}));
    EXPECT_EQ(image.metadata.text.size(), 4U);
    EXPECT_EQ(read_file(summary.files[1], kImageInput), baked_files(preset, 1)[1]);
}

// A PNG stores the mask of films as 8-bit codes; an EXR stores it as numbers from 0 to 1.
TEST(FrameFiles, AMapAloneIsAnExrWithoutLayers) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film"};
    const BakeSummary coded = bake(preset, {.frames = {1}, .threads = 1}, {});
    preset.output.pattern = (folder.path() / "{map}.exr").string();
    const BakeSummary whole = bake(preset, {.frames = {1}, .threads = 1}, {});
    const Picture image = read_picture(whole.files.front());
    EXPECT_EQ(channel_names(image), std::vector<std::string>{"Y"});
    EXPECT_FALSE(image.metadata.color);
    const auto& numbers = floats(image.groups.front());
    const Image<std::uint8_t> codes = codes8(read_picture(coded.files.front()));
    for (std::size_t k = 0; k < codes.samples().size(); ++k) {
        EXPECT_NEAR(numbers.samples()[k], codes.samples()[k] / 255.0, 0.5001 / 255.0);
    }
}

// The conversion itself is tested in tests/texgen/image/primaries_test.cpp. Half floats have a
// relative error of up to 2^-11.
TEST(FrameFiles, PrimariesChangeColorsButNoData) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"albedo", "height", "normal"};
    preset.output.pattern = (folder.path() / "layers.exr").string();
    const auto layers = [&](Primaries primaries) {
        preset.output.primaries = primaries;
        return read_picture(bake(preset, {.frames = {1}, .threads = 1}, {}).files.front());
    };
    Picture srgb = layers(Primaries::Srgb);
    const Picture acescg = layers(Primaries::AcesCg);
    EXPECT_EQ(acescg.metadata.primaries, Primaries::AcesCg);
    ASSERT_EQ(channel_names(acescg), channel_names(srgb));
    convert_colors(srgb, "albedo", Primaries::Srgb, Primaries::AcesCg);
    for (std::size_t k = 0; k < srgb.groups.size(); ++k) {
        const auto expected = floats(srgb.groups[k]).samples();
        const auto found = floats(acescg.groups[k]).samples();
        const bool is_color = acescg.groups[k].names.front().starts_with("albedo");
        for (std::size_t sample = 0; sample < expected.size(); ++sample) {
            EXPECT_NEAR(found[sample], expected[sample], is_color ? 1e-3 : 0.0);
        }
    }
}

TEST(FrameFiles, OnlyAnExrStoresOtherPrimaries) {
    Preset preset = small_preset("x.####.png");
    preset.output.primaries = Primaries::AcesCg;
    try {
        check_bake(preset, {.frames = {1}});
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "output.primaries = \"acescg\" needs EXR files, but output.pattern is "
                     "'x.####.png'");
    }
}

TEST(FrameFiles, FilesHaveNoTextsIfTheyAreLeftOut) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.output.texts = FileTexts::LeftOut;
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    EXPECT_TRUE(read_picture(summary.files.front()).metadata.text.empty());
}

TEST(FrameFiles, FilesRecordHowTheyWereMade) {
    const TemporaryFolder folder;
    const BakeSummary summary =
        bake(small_preset(folder.path() / kPattern), {.frames = {1}, .threads = 1}, {});
    const Picture image = read_picture(summary.files.front());
    EXPECT_TRUE(image.metadata.color);
    const auto text = [&](const std::string& keyword) {
        for (const auto& [key, value] : image.metadata.text) {
            if (key == keyword) {
                return value;
            }
        }
        return std::string();
    };
    EXPECT_EQ(text("Seed"), "12");
    EXPECT_EQ(text("Software"), "foamtex " FOAMTEX_VERSION);
    EXPECT_NE(text("Preset").find("bubbles = 40"), std::string::npos);
}

TEST(FrameFiles, FilesOfMapsDescribeTheirNumbers) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"normal", "height"};
    preset.maps.normal.y = NormalY::Down;
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    const auto texts = read_picture(summary.files.front()).metadata.text;
    const auto has = [&](const std::string& key, const std::string& value) {
        return std::find(texts.begin(), texts.end(), std::pair(key, value)) != texts.end();
    };
    EXPECT_TRUE(has("Map", "normal"));
    EXPECT_TRUE(has("Note", "y down (DirectX)"));
    EXPECT_TRUE(has("Unit", std::string(find_map("normal").unit)));
    EXPECT_EQ(read_picture(summary.files.back()).groups.front().type, SampleType::Uint16);
}

// The mean of a packed channel is the mean of the file of its map, because both store the same
// codes.
TEST(FrameFiles, APackedImageHoldsTheCodesOfItsMaps) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film", "roughness"};
    preset.output.pack = {"P=film,1-roughness,1,0.2"};
    preset.output.names = {"film=mask"};
    preset.output.pattern = (folder.path() / "{map}.png").string();
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"P.png", "mask.png", "roughness.png"}));
    const Image<std::uint8_t> film = codes8(read_picture(folder.path() / "mask.png"));
    const Image<std::uint8_t> roughness = codes8(read_picture(folder.path() / "roughness.png"));
    const Picture picture = read_picture(folder.path() / "P.png");
    const Image<std::uint8_t> packed = codes8(picture);
    EXPECT_FALSE(picture.metadata.color);
    for (std::size_t k = 0; k < film.samples().size(); ++k) {
        EXPECT_EQ(packed.samples()[4 * k], film.samples()[k]);
        EXPECT_NEAR(packed.samples()[4 * k + 1], 255 - roughness.samples()[k], 1);
        EXPECT_EQ(packed.samples()[4 * k + 2], 255);
        EXPECT_EQ(packed.samples()[4 * k + 3], 51);
    }
}

// In a file of layers, a packed image is a layer.
TEST(FrameFiles, APackedImageIsALayerOfAnExr) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film"};
    preset.output.pack = {"P=film,0,1"};
    preset.output.pattern = (folder.path() / "layers.exr").string();
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    EXPECT_EQ(channel_names(read_picture(summary.files.front())),
              (std::vector<std::string>{"P.B", "P.G", "P.R", "film.Y"}));
}

TEST(FrameFiles, APackingOfColorsIsNoExr) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.output.pack = {"P=albedo.R,albedo.G,albedo.B,film"};
    preset.output.pattern = (folder.path() / "{map}.exr").string();
    EXPECT_THROW(check_bake(preset, {.frames = {1}}), std::invalid_argument);
    preset.output.pattern = (folder.path() / "{map}.png").string();
    EXPECT_NO_THROW(check_bake(preset, {.frames = {1}}));
}

}  // namespace
}  // namespace foam::texgen
