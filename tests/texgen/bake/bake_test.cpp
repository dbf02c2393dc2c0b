#include "texgen/bake/bake.h"

#include "tests/texgen/small_preset.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/exr.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"
#include "texgen/maps/map.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kPattern = "deep/{preset}_{map}.####.png";

std::vector<Bytes> baked_files(const Preset& preset, int threads) {
    const BakeSummary summary = bake(preset, {.frames = {1, 2, 3, 4, 5}, .threads = threads}, {});
    std::vector<Bytes> contents;
    for (const std::filesystem::path& path : summary.files) {
        contents.push_back(read_file(path));
    }
    return contents;
}

// Which files differ, and whether their pixels do, too.
std::string differences(const std::vector<Bytes>& a, const std::vector<Bytes>& b) {
    std::string found = a.size() == b.size() ? "" : "another number of files";
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (a[k] != b[k]) {
            const bool alike = decode_png(a[k]).pixels == decode_png(b[k]).pixels;
            found += fmt::format("file {}: {} ", k + 1, alike ? "bytes" : "pixels");
        }
    }
    return found;
}

TEST(Bake, GivesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    const std::vector<Bytes> one = baked_files(preset, 1);
    ASSERT_EQ(one.size(), 5U);
    EXPECT_NE(one.front(), one.back());
    EXPECT_EQ(differences(one, baked_files(preset, 2)), "");
    EXPECT_EQ(differences(one, baked_files(preset, 3)), "");
}

TEST(Bake, AFrameIsTheSameWhetherOthersAreBakedOrNot) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    const std::vector<Bytes> all = baked_files(preset, 2);
    const BakeSummary third = bake(preset, {.frames = {3}, .threads = 2}, {});
    ASSERT_EQ(third.files.size(), 1U);
    EXPECT_EQ(read_file(third.files.front()), all[2]);
}

// Of a patch as well; frames 4 and 5 are seen as frame 1 decided, whether it is drawn or not.
TEST(Bake, FramesOfAPatchAreSeenAlike) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.shape.kind = FoamKind::Patch;
    preset.coarsening.kappa = 0.02;
    const std::vector<Bytes> all = baked_files(preset, 1);
    EXPECT_EQ(all, baked_files(preset, 3));
    const BakeSummary later = bake(preset, {.frames = {4, 5}, .threads = 2}, {});
    ASSERT_EQ(later.files.size(), 2U);
    EXPECT_EQ(read_file(later.files[1]), all[4]);
    const PngImage image = decode_png(all[4]);
    EXPECT_EQ(image.pixels.channels(), 4);
    EXPECT_EQ(image.pixels.pixel(0, 0)[3], 0);
    EXPECT_EQ(image.pixels.pixel(32, 32)[3], 255);
}

TEST(Bake, ListsFilesInTheOrderAskedFor) {
    const TemporaryFolder folder;
    const BakeSummary summary =
        bake(small_preset(folder.path() / kPattern), {.frames = {3, 1}, .threads = 2}, {});
    ASSERT_EQ(summary.files.size(), 2U);
    EXPECT_EQ(summary.files[0].filename(), "small_albedo.0003.png");
    EXPECT_EQ(summary.files[1].filename(), "small_albedo.0001.png");
}

// Colours say so, data does not, as their numbers mean nothing to the eye.
TEST(Bake, WritesEveryMapOfAFrame) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film", "albedo", "pressure"};
    const BakeSummary summary = bake(preset, {.frames = {2, 1}, .threads = 2}, {});
    std::vector<std::string> names;
    std::vector<bool> colors;
    for (const std::filesystem::path& path : summary.files) {
        names.push_back(path.filename().string());
        colors.push_back(read_png16(path).metadata.color);
    }
    EXPECT_EQ(names,
              (std::vector<std::string>{"small_film.0002.png",
                                        "small_albedo.0002.png",
                                        "small_pressure.0002.png",
                                        "small_film.0001.png",
                                        "small_albedo.0001.png",
                                        "small_pressure.0001.png"}));
    EXPECT_EQ(colors, (std::vector<bool>{false, true, false, false, true, false}));
}

// The scale of pressures is frame 1's, drawn or not.
TEST(Bake, EveryMapOfAFrameIsTheSameWhetherOthersAreBakedOrNot) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    const auto names = map_names();
    preset.image.maps.assign(names.begin(), names.end());
    const BakeSummary all = bake(preset, {.frames = {1, 2, 3}, .threads = 2}, {});
    std::vector<Bytes> third;
    for (std::size_t k = 2 * names.size(); k < all.files.size(); ++k) {
        third.push_back(read_file(all.files[k]));
    }
    const BakeSummary alone = bake(preset, {.frames = {3}, .threads = 1}, {});
    ASSERT_EQ(alone.files.size(), names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        EXPECT_EQ(read_file(alone.files[k]), third[k]) << names[k];
    }
}

std::vector<std::string> channel_names(const ExrImage& image) {
    std::vector<std::string> names;
    for (const ExrPlane& plane : image.channels) {
        names.push_back(plane.name);
    }
    return names;
}

// Without {map} in its name, an EXR holds every map as a layer, in the order of their names.
TEST(Bake, AnExrHoldsAllMapsOfAFrame) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film", "albedo"};
    preset.output.pattern = (folder.path() / "layers.####.exr").string();
    preset.output.frames_per_second = 30;
    const BakeSummary summary = bake(preset, {.frames = {1, 2}, .threads = 2}, {});
    ASSERT_EQ(summary.files.size(), 2U);
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"layers.0001.exr", "layers.0002.exr"}));
    const ExrImage image = read_exr(summary.files[1]);
    EXPECT_EQ(channel_names(image),
              (std::vector<std::string>{"albedo.B", "albedo.G", "albedo.R", "film.Y"}));
    EXPECT_TRUE(image.metadata.periodic);
    EXPECT_TRUE(image.metadata.color);
    EXPECT_EQ(image.metadata.frame_rate, (FrameRate{30, 1}));
    EXPECT_EQ(image.metadata.text.size(), 4U);
    EXPECT_EQ(read_file(summary.files[1]), baked_files(preset, 1)[1]);
}

// What is drawn for a PNG of 8 bits, an EXR has in its own unit: the mask from 0 to 1.
TEST(Bake, AMapAloneIsAnExrWithoutLayers) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film"};
    const BakeSummary coded = bake(preset, {.frames = {1}, .threads = 1}, {});
    preset.output.pattern = (folder.path() / "{map}.exr").string();
    const BakeSummary whole = bake(preset, {.frames = {1}, .threads = 1}, {});
    const ExrImage image = read_exr(whole.files.front());
    EXPECT_EQ(channel_names(image), std::vector<std::string>{"Y"});
    EXPECT_FALSE(image.metadata.color);
    const auto& numbers = std::get<Image<float>>(image.channels.front().pixels);
    const Image<std::uint8_t> codes = read_png(coded.files.front()).pixels;
    for (std::size_t k = 0; k < codes.samples().size(); ++k) {
        EXPECT_NEAR(numbers.samples()[k], codes.samples()[k] / 255.0, 0.5001 / 255.0);
    }
}

TEST(Bake, FilesTellNothingWhereTextsAreLeftOut) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.output.texts = FileTexts::LeftOut;
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    EXPECT_TRUE(read_png(summary.files.front()).metadata.text.empty());
}

TEST(Bake, CompressionChangesNoPixel) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    std::vector<std::size_t> sizes;
    std::vector<Image<std::uint8_t>> pictures;
    for (const Compression compression :
         {Compression::None, Compression::Fast, Compression::Small}) {
        preset.output.png_compression = compression;
        const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
        sizes.push_back(read_file(summary.files.front()).size());
        pictures.push_back(read_png(summary.files.front()).pixels);
    }
    EXPECT_GT(sizes[0], sizes[1]);
    EXPECT_GT(sizes[1], sizes[2]);
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(Bake, FilesTellHowTheyWereMade) {
    const TemporaryFolder folder;
    const BakeSummary summary =
        bake(small_preset(folder.path() / kPattern), {.frames = {1}, .threads = 1}, {});
    const PngImage image = read_png(summary.files.front());
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

TEST(Bake, FilesOfMapsTellWhatTheirNumbersAre) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"normal", "height"};
    preset.maps.normal.y = NormalY::Down;
    const BakeSummary summary = bake(preset, {.frames = {1}, .threads = 1}, {});
    const auto texts = read_png(summary.files.front()).metadata.text;
    const auto has = [&](const std::string& key, const std::string& value) {
        return std::find(texts.begin(), texts.end(), std::pair(key, value)) != texts.end();
    };
    EXPECT_TRUE(has("Map", "normal"));
    EXPECT_TRUE(has("Note", "y down (DirectX)"));
    EXPECT_TRUE(has("Unit", std::string(find_map("normal").unit)));
    EXPECT_NO_THROW(read_png16(summary.files.back()));
    EXPECT_THROW(read_png(summary.files.back()), InputError);  // 16 bits a sample
}

TEST(Bake, TellsItsProgressOnceAFrame) {
    const TemporaryFolder folder;
    std::vector<int> done;
    bake(small_preset(folder.path() / kPattern),
         {.frames = {1, 2, 3}, .threads = 2},
         {.on_progress = [&](const BakeProgress& p) {
             done.push_back(p.done);
             EXPECT_EQ(p.total, 3);
             EXPECT_LT(p.angle_error, 1e-9);
         }});
    EXPECT_EQ(done, (std::vector<int>{1, 2, 3}));
}

TEST(Bake, RefusesFramesThatAreNone) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    EXPECT_THROW(bake(preset, {.frames = {}, .threads = 1}, {}), std::invalid_argument);
    EXPECT_THROW(bake(preset, {.frames = {0}, .threads = 1}, {}), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "deep"));
}

TEST(Bake, SaysWhichFolderCannotBeMade) {
    const TemporaryFolder folder;
    write_file(folder.path() / "deep", {});  // a file stands where the folder should be
    const auto run = [&] {
        bake(small_preset(folder.path() / kPattern), {.frames = {1}, .threads = 2}, {});
    };
    EXPECT_THROW(run(), OutputError);
}

}  // namespace

}  // namespace foam::texgen
