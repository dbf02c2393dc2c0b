// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/preview_textures.h"

#include "core/files/file_io.h"
#include "tests/texgen/material/baked_material.h"
#include "texgen/image/format.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <variant>

namespace foam::texgen {
namespace {

using Pixels = Image<std::uint8_t>;

Pixels pixels_in(const std::filesystem::path& path) {
    return std::get<Pixels>(read_picture(path).groups.front().samples);
}

// Returns the largest difference of the samples of two images.
int largest_difference(const Pixels& a, const Pixels& b) {
    EXPECT_EQ(a.samples().size(), b.samples().size());
    int largest = 0;
    for (std::size_t k = 0; k < std::min(a.samples().size(), b.samples().size()); ++k) {
        largest = std::max(largest, std::abs(int{a.samples()[k]} - int{b.samples()[k]}));
    }
    return largest;
}

TEST(PreviewTextures, CopiesImagesOfEightBits) {
    const TemporaryFolder folder;
    const PreviewTextures textures = preview_textures(
        baked_material(small_material(folder, {"albedo", "emission", "normal"}), folder));
    EXPECT_EQ(largest_difference(*textures.color, pixels_in(folder.path() / "albedo.0001.png")), 0);
    EXPECT_EQ(
        largest_difference(*textures.emission, pixels_in(folder.path() / "emission.0001.png")), 0);
    EXPECT_EQ(largest_difference(*textures.normal, pixels_in(folder.path() / "normal.0001.png")),
              0);
    EXPECT_EQ(textures.surface, std::nullopt);
}

// An EXR has linear light and normals from -1 to 1; a half float has an error of 1/2048. The y of
// normal_dx is turned.
TEST(PreviewTextures, OfExrsAreThoseOfPngs) {
    const TemporaryFolder folder;
    baked_material(small_material(folder, {"albedo", "normal_gl", "roughness"}), folder);
    const TemporaryFolder exr;
    const PreviewTextures textures = preview_textures(
        baked_material(small_material(exr, {"albedo", "normal_dx", "roughness"}, ".exr"), exr));
    EXPECT_LE(largest_difference(*textures.color, pixels_in(folder.path() / "albedo.0001.png")), 1);
    EXPECT_LE(largest_difference(*textures.normal, pixels_in(folder.path() / "normal_gl.0001.png")),
              1);
    const Pixels roughness = pixels_in(folder.path() / "roughness.0001.png");
    for (int x = 0; x < roughness.width(); ++x) {
        EXPECT_NEAR(textures.surface->pixel(x, 3)[1], roughness.pixel(x, 3)[0], 1);
        EXPECT_EQ(textures.surface->pixel(x, 3)[0], 255);
        EXPECT_EQ(textures.surface->pixel(x, 3)[2], 0);
    }
}

// The colors of a patch in an EXR are multiplied by the opacity.
TEST(PreviewTextures, OfAPatchHaveStraightColors) {
    const auto color = [](const TemporaryFolder& folder, const std::string& suffix) {
        Preset preset = small_material(folder, {"albedo"}, suffix);
        preset.shape.kind = FoamKind::Patch;
        return *preview_textures(baked_material(preset, folder, {1})).color;
    };
    const TemporaryFolder png;
    const TemporaryFolder exr;
    const Pixels straight = color(png, ".png");
    const Pixels divided = color(exr, ".exr");
    EXPECT_EQ(straight.channels(), 4);
    for (int y = 0; y < straight.height(); ++y) {
        for (int x = 0; x < straight.width(); ++x) {
            EXPECT_NEAR(straight.pixel(x, y)[3], divided.pixel(x, y)[3], 1);
            if (straight.pixel(x, y)[3] > 128) {
                EXPECT_NEAR(straight.pixel(x, y)[0], divided.pixel(x, y)[0], 2);
            }
        }
    }
}

TEST(PreviewTextures, OfAPatchWithoutColorsAreWhiteWithItsOpacity) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"normal", "opacity"});
    preset.shape.kind = FoamKind::Patch;
    const Pixels white = *preview_textures(baked_material(preset, folder, {1})).color;
    const Pixels opacity = pixels_in(folder.path() / "opacity.0001.png");
    ASSERT_EQ(white.channels(), 4);
    EXPECT_EQ(std::ranges::min(opacity.samples()), 0);
    EXPECT_EQ(std::ranges::max(opacity.samples()), 255);
    for (int y = 0; y < white.height(); ++y) {
        for (int x = 0; x < white.width(); ++x) {
            EXPECT_EQ(white.pixel(x, y)[0], 255);
            EXPECT_EQ(white.pixel(x, y)[3], opacity.pixel(x, y)[0]);
        }
    }
}

TEST(PreviewTextures, PackChannelsOfSeveralImages) {
    const TemporaryFolder folder;
    Preset preset = small_material(folder, {"occlusion"});
    preset.maps.metallic.cell = 1.0;
    preset.output.pack = {"P=0,0,metallic,1-roughness"};
    const Pixels surface = *preview_textures(baked_material(preset, folder)).surface;
    const Pixels occlusion = pixels_in(folder.path() / "occlusion.0001.png");
    const Pixels packed = pixels_in(folder.path() / "P.0001.png");
    for (int x = 0; x < surface.width(); ++x) {
        EXPECT_EQ(surface.pixel(x, 5)[0], occlusion.pixel(x, 5)[0]);
        EXPECT_EQ(surface.pixel(x, 5)[1], 255 - packed.pixel(x, 5)[3]);
        EXPECT_EQ(surface.pixel(x, 5)[2], packed.pixel(x, 5)[2]);
    }
}

// Layers of an EXR, 16-bit codes and compressed textures are converted, too.
TEST(PreviewTextures, AreMadeOfFilesOfAllFormats) {
    for (const char* const pattern : {"layers.####.exr", "{map}.####.dds", "{map}.####.ktx2"}) {
        const TemporaryFolder folder;
        Preset preset = small_material(folder, {"albedo", "normal", "roughness", "height"});
        preset.output.pattern = (folder.path() / pattern).string();
        preset.output.pack = {"W:16=occlusion,metallic,0"};
        const PreviewTextures textures = preview_textures(baked_material(preset, folder, {1}));
        EXPECT_TRUE(textures.color && textures.normal && textures.surface) << pattern;
    }
}

TEST(PreviewTextures, AMissingFileIsReported) {
    const TemporaryFolder folder;
    const SceneMaterial material = baked_material(small_material(folder, {"albedo"}), folder);
    std::filesystem::remove(folder.path() / "albedo.0001.png");
    EXPECT_THROW(preview_textures(material), InputError);
}

}  // namespace
}  // namespace foam::texgen
