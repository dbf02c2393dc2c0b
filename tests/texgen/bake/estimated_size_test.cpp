// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/estimated_size.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/bake/bake.h"
#include "texgen/maps/all_maps.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace foam::texgen {
namespace {

// A preset of all maps, with the number of pixels per bubble that sea_foam has.
Preset preset_of_all_maps(const std::filesystem::path& pattern) {
    Preset preset = small_preset(pattern);
    preset.seeding.bubbles = 25;
    preset.image.width = preset.image.height = 256;
    preset.image.maps.clear();
    for (const Map& map : all_maps()) {
        preset.image.maps.emplace_back(map.name);
    }
    preset.output.texts = FileTexts::LeftOut;
    return preset;
}

double written_size(const Preset& preset) {
    double size = 0.0;
    for (const std::filesystem::path& path :
         bake(preset, {.frames = {1}, .threads = 1}, {}).files) {
        size += static_cast<double>(std::filesystem::file_size(path));
    }
    return size;
}

TEST(EstimatedSize, IsRightWithinAFactorOfTwo) {
    for (const char* const name :
         {"{map}.png", "{map}.exr", "layers.exr", "{map}.raw.png", "{map}.mip.exr"}) {
        const TemporaryFolder folder;
        Preset preset = preset_of_all_maps(folder.path() / name);
        const std::string pattern = name;
        if (pattern.find("raw") != std::string::npos) {
            preset.output.png_compression = Compression::None;
        }
        if (pattern.find("mip") != std::string::npos) {
            preset.output.exr_layout = ExrLayout::MipLevels;
        }
        const auto estimated = static_cast<double>(estimated_size(preset, {1}));
        const double ratio = estimated / written_size(preset);
        EXPECT_GT(ratio, 0.5) << name;
        EXPECT_LT(ratio, 2.0) << name;
    }
}

TEST(EstimatedSize, OfMeshesIsRightWithinAFactorOfTwo) {
    for (const char* const name : {"x.stl", "x.glb"}) {
        for (const char* const map : {"albedo", "maze"}) {
            const TemporaryFolder folder;
            Preset preset = small_preset(folder.path() / name);
            preset.image.maps = {map};
            const auto estimated = static_cast<double>(estimated_size(preset, {1}));
            const double ratio = estimated / written_size(preset);
            EXPECT_GT(ratio, 0.5) << name << ' ' << map;
            EXPECT_LT(ratio, 2.0) << name << ' ' << map;
        }
    }
}

// Without compression, a PNG of pressures has 2 bytes per pixel, and one of their colors has 3.
TEST(EstimatedSize, DependsOnTheColorMapOfPressures) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "{map}.png");
    preset.image.maps = {"pressure"};
    preset.output.png_compression = Compression::None;
    const std::uint64_t of_numbers = estimated_size(preset, {1});
    preset.maps.pressure.colormap = "viridis";
    EXPECT_EQ(2 * estimated_size(preset, {1}), 3 * of_numbers);
}

TEST(EstimatedSize, CountsEachMissingFile) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / "{map}.####.png");
    preset.image.maps = {"lit", "height"};
    const std::uint64_t both = estimated_size(preset, {1});
    EXPECT_EQ(estimated_size(preset, {1, 2, 3}), 3 * both);
    write_file(folder.path() / "lit.0002.png", {});
    preset.image.maps = {"height"};
    EXPECT_EQ(estimated_size(preset, {2}), estimated_size(preset, {1}));
    preset.image.maps = {"lit"};
    EXPECT_EQ(estimated_size(preset, {2}), 0U);
    EXPECT_GT(estimated_size(preset, {1}), 0U);
}

}  // namespace
}  // namespace foam::texgen
