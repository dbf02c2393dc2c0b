// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/array_files.h"

#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/dds.h"
#include "texgen/image/ktx2.h"
#include "texgen/sheet/flipbook.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

GpuTexture array_in(const TemporaryFolder& folder, const char* map) {
    return decode_dds(
        read_file(folder.path() / ("small_array_" + std::string(map) + ".dds"), kImageInput));
}

nlohmann::json array_json_in(const TemporaryFolder& folder) {
    std::ifstream file(folder.path() / "small_array.json");
    return nlohmann::json::parse(file);
}

// A layer holds the pixels of its frame. Samples of 16 bits and ids are not compressed.
TEST(ArrayFiles, EveryFrameIsALayer) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"height", "id", "motion", "albedo"});
    write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    for (const char* map : {"height", "id", "motion"}) {
        GpuTexture array = array_in(folder, map);
        EXPECT_TRUE(array.is_array);
        EXPECT_EQ(array.levels(), 6);
        ASSERT_EQ(array.layers.size(), 4U);
        for (std::size_t k = 0; k < 4; ++k) {
            GpuTexture layer = array;
            layer.layers = {array.layers[k]};
            const std::string name =
                "small_" + std::string(map) + ".000" + std::to_string(k + 1) + ".png";
            EXPECT_EQ(codes16(picture_of(layer)), codes16(read_picture(folder.path() / name)))
                << name;
        }
    }
    EXPECT_EQ(array_in(folder, "albedo").format, PixelFormat::Bc7Srgb);
    EXPECT_EQ(array_in(folder, "motion").format, PixelFormat::Rg16);
}

TEST(ArrayFiles, DdsFramesAreCopied) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path(), ".dds"), {"albedo"});
    write_flipbook(set, folder.path(), {.frames = {3, 1}, .array_suffix = ".dds"}, folder.path());
    const GpuTexture array = array_in(folder, "albedo");
    ASSERT_EQ(array.layers.size(), 2U);
    const auto frame = [&](const char* name) {
        return decode_dds(read_file(folder.path() / name, kImageInput)).layers.front();
    };
    EXPECT_EQ(array.layers[0], frame("small_albedo.0003.dds"));
    EXPECT_EQ(array.layers[1], frame("small_albedo.0001.dds"));
    EXPECT_THROW(write_flipbook(set, folder.path(), {}, folder.path()), std::invalid_argument);
}

// Returns the message with which the frames of a set cannot become an array.
std::string failure_of(const BakedSet& set, const TemporaryFolder& folder) {
    try {
        write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    } catch (const InputError& error) {
        return error.what();
    }
    return "no failure";
}

TEST(ArrayFiles, ADamagedFrameIsNamed) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path(), ".dds"), {"albedo"});
    const std::filesystem::path path = folder.path() / "small_albedo.0002.dds";
    std::filesystem::resize_file(path, 200);
    EXPECT_EQ(failure_of(set, folder),
              "cannot read '" + path.string() + "': the file ends too early");
}

TEST(ArrayFiles, AFrameMustHaveOneLayer) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path(), ".dds"), {"albedo"});
    write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    for (const char* const frame : {"small_albedo.0003.dds", "small_albedo.0001.dds"}) {
        const std::filesystem::path path = folder.path() / frame;
        std::filesystem::copy_file(folder.path() / "small_array_albedo.dds",
                                   path,
                                   std::filesystem::copy_options::overwrite_existing);
        EXPECT_EQ(failure_of(set, folder),
                  "cannot read '" + path.string() +
                      "': the file is an array of 4 layers, not a single image");
    }
}

TEST(ArrayFiles, TheJsonDescribesLayers) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"height"});
    write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    const auto json = array_json_in(folder);
    EXPECT_EQ(json["layout"]["layers"], 4);
    EXPECT_EQ(json["layout"]["frame_size"], (std::vector<int>{32, 24}));
    EXPECT_EQ(json["images"][0]["file"], "small_array_height.dds");
    EXPECT_EQ(json["images"][0]["pixel_format"], "R16_UNORM");
    EXPECT_EQ(json["images"][0]["mip_levels"], 6);
    EXPECT_EQ(json["loop"]["closes"], true);
}

// Frames without mip levels become layers without mip levels.
TEST(ArrayFiles, TheJsonHasTheMipLevelsOfTheFrames) {
    const TemporaryFolder folder;
    Preset preset = small_loop(folder.path(), ".dds");
    preset.output.mip_levels = false;
    const BakedSet set = baked(preset, {"height"});
    write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    EXPECT_EQ(array_in(folder, "height").levels(), 1);
    EXPECT_EQ(array_json_in(folder)["images"][0]["mip_levels"], 1);
}

TEST(ArrayFiles, NumbersAreRejected) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path(), ".exr"), {"height", "id"});
    for (const auto& [map, type] : {std::pair("height", "float"), std::pair("id", "uint32")}) {
        try {
            write_flipbook(
                set, folder.path(), {.maps = {map}, .array_suffix = ".dds"}, folder.path());
            ADD_FAILURE() << map;
        } catch (const InputError& error) {
            const std::string reason = "samples of the type " + std::string(type);
            EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
        }
    }
}

TEST(ArrayFiles, AnArrayHasNoGutter) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"height"});
    EXPECT_THROW(
        write_flipbook(set, folder.path(), {.gutter = 1, .array_suffix = ".dds"}, folder.path()),
        std::invalid_argument);
}

// A KTX2 array holds the same images as a DDS array.
TEST(ArrayFiles, AreWrittenAsKtx2) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    write_flipbook(set, folder.path(), {.array_suffix = ".dds"}, folder.path());
    write_flipbook(set, folder.path(), {.array_suffix = ".ktx2"}, folder.path());
    const GpuTexture array =
        decode_ktx2(read_file(folder.path() / "small_array_albedo.ktx2", kImageInput));
    EXPECT_TRUE(array.is_array);
    EXPECT_EQ(array.layers, array_in(folder, "albedo").layers);
}

// All four frames of the loop close it, at 24 frames per second. Every second of them, in reverse
// order, too, at half the rate. Three frames do not.
TEST(ArrayFiles, AKtx2StoresTheAnimation) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"height"});
    const auto animation_of = [&](const std::vector<int>& frames) {
        write_flipbook(
            set, folder.path(), {.frames = frames, .array_suffix = ".ktx2"}, folder.path());
        const auto path = folder.path() / "small_array_height.ktx2";
        return decode_ktx2(read_file(path, kImageInput)).animation;
    };
    EXPECT_EQ(animation_of({}), (TextureAnimation{{24, 1}, true}));
    EXPECT_EQ(animation_of({4, 2}), (TextureAnimation{{24, 2}, true}));
    EXPECT_EQ(animation_of({1, 2, 3}), (TextureAnimation{{24, 1}, false}));
}

}  // namespace
}  // namespace foam::texgen
