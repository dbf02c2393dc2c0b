#include "texgen/bake/bake.h"

#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"
#include "texgen/image/png.h"
#include "texgen/maps/map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

Preset small_preset(const std::filesystem::path& folder) {
    Preset preset;
    preset.name = "small";
    preset.description = "a small foam";
    preset.seeding.bubbles = 40;
    preset.seeding.seed = 12;
    preset.image.width = 64;
    preset.image.height = 64;
    preset.output.pattern = (folder / "deep" / "{preset}_{map}.####.png").string();
    return preset;
}

std::vector<Bytes> baked_files(const Preset& preset, int threads) {
    const BakeSummary summary = bake(preset, {.frames = {1, 2, 3, 4, 5}, .threads = threads}, {});
    std::vector<Bytes> contents;
    for (const std::filesystem::path& path : summary.files) {
        contents.push_back(read_file(path));
    }
    return contents;
}

TEST(Bake, GivesTheSameBytesForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path());
    const std::vector<Bytes> one = baked_files(preset, 1);
    ASSERT_EQ(one.size(), 5U);
    EXPECT_NE(one.front(), one.back());
    EXPECT_EQ(one, baked_files(preset, 2));
    EXPECT_EQ(one, baked_files(preset, 3));
}

TEST(Bake, AFrameIsTheSameWhetherOthersAreBakedOrNot) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path());
    const std::vector<Bytes> all = baked_files(preset, 2);
    const BakeSummary third = bake(preset, {.frames = {3}, .threads = 2}, {});
    ASSERT_EQ(third.files.size(), 1U);
    EXPECT_EQ(read_file(third.files.front()), all[2]);
}

// Of a patch as well; frames 4 and 5 are seen as frame 1 decided, whether it is drawn or not.
TEST(Bake, FramesOfAPatchAreSeenAlike) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path());
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
        bake(small_preset(folder.path()), {.frames = {3, 1}, .threads = 2}, {});
    ASSERT_EQ(summary.files.size(), 2U);
    EXPECT_EQ(summary.files[0].filename(), "small_albedo.0003.png");
    EXPECT_EQ(summary.files[1].filename(), "small_albedo.0001.png");
}

// Colours say so, data does not, as their numbers mean nothing to the eye.
TEST(Bake, WritesEveryMapOfAFrame) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path());
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
    Preset preset = small_preset(folder.path());
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

TEST(Bake, FilesTellHowTheyWereMade) {
    const TemporaryFolder folder;
    const BakeSummary summary =
        bake(small_preset(folder.path()), {.frames = {1}, .threads = 1}, {});
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
    Preset preset = small_preset(folder.path());
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
    bake(small_preset(folder.path()),
         {.frames = {1, 2, 3}, .threads = 2},
         [&](const BakeProgress& p) {
             done.push_back(p.done);
             EXPECT_EQ(p.total, 3);
             EXPECT_LT(p.angle_error, 1e-9);
         });
    EXPECT_EQ(done, (std::vector<int>{1, 2, 3}));
}

TEST(Bake, RefusesFramesThatAreNone) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path());
    EXPECT_THROW(bake(preset, {.frames = {}, .threads = 1}, {}), std::invalid_argument);
    EXPECT_THROW(bake(preset, {.frames = {0}, .threads = 1}, {}), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "deep"));
}

TEST(Bake, SaysWhichFolderCannotBeMade) {
    const TemporaryFolder folder;
    write_file(folder.path() / "deep", {});  // a file stands where the folder should be
    const auto run = [&] { bake(small_preset(folder.path()), {.frames = {1}, .threads = 2}, {}); };
    EXPECT_THROW(run(), OutputError);
}

}  // namespace

}  // namespace foam::texgen
