// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/bake.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/bake/baked_files.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/small_preset.h"
#include "texgen/image/png.h"
#include "texgen/maps/all_maps.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// Returns a list of the files that differ, each with "pixels" if its pixels differ, and "bytes" if
// only its encoding differs. Returns an empty text if all files are equal.
std::string differences(const std::vector<Bytes>& a, const std::vector<Bytes>& b) {
    std::string found = a.size() == b.size() ? "" : "another number of files";
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) {
        if (a[k] != b[k]) {
            const bool alike = codes8(decode_png(a[k])) == codes8(decode_png(b[k]));
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

TEST(Bake, FramesDoNotDependOnTheOtherFramesBaked) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    const std::vector<Bytes> all = baked_files(preset, 2);
    const BakeSummary third = bake(preset, {.frames = {3}, .threads = 2}, {});
    ASSERT_EQ(third.files.size(), 1U);
    EXPECT_EQ(read_file(third.files.front(), kImageInput), all[2]);
}

// The files of a patch do not depend on the number of threads either. Frame 1 determines the view
// of all frames, even if it is not drawn.
TEST(Bake, FramesOfAPatchAreSeenAlike) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.shape.kind = FoamKind::Patch;
    preset.coarsening.kappa = 0.02;
    const std::vector<Bytes> all = baked_files(preset, 1);
    EXPECT_EQ(all, baked_files(preset, 3));
    const BakeSummary later = bake(preset, {.frames = {4, 5}, .threads = 2}, {});
    ASSERT_EQ(later.files.size(), 2U);
    EXPECT_EQ(read_file(later.files[1], kImageInput), all[4]);
    const Image<std::uint8_t> image = codes8(decode_png(all[4]));
    EXPECT_EQ(image.channels(), 4);
    EXPECT_EQ(image.pixel(0, 0)[3], 0);
    EXPECT_EQ(image.pixel(32, 32)[3], 255);
}

TEST(Bake, ListsFilesInTheOrderAskedFor) {
    const TemporaryFolder folder;
    const BakeSummary summary =
        bake(small_preset(folder.path() / kPattern), {.frames = {3, 1}, .threads = 2}, {});
    ASSERT_EQ(summary.files.size(), 2U);
    EXPECT_EQ(summary.files[0].filename(), "small_albedo.0003.png");
    EXPECT_EQ(summary.files[1].filename(), "small_albedo.0001.png");
}

// Only maps of colors are marked as color. The maps film and pressure store data.
TEST(Bake, WritesEveryMapOfAFrame) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    preset.image.maps = {"film", "albedo", "pressure"};
    const BakeSummary summary = bake(preset, {.frames = {2, 1}, .threads = 2}, {});
    std::vector<std::string> names;
    std::vector<bool> colors;
    for (const std::filesystem::path& path : summary.files) {
        names.push_back(path.filename().string());
        colors.push_back(read_picture(path).metadata.color);
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

// Frame 1 determines the scale of pressures, even if it is not drawn.
TEST(Bake, MapsDoNotDependOnTheOtherMapsBaked) {
    const TemporaryFolder folder;
    Preset preset = small_preset(folder.path() / kPattern);
    const auto names = map_names();
    preset.image.maps.assign(names.begin(), names.end());
    const BakeSummary all = bake(preset, {.frames = {1, 2, 3}, .threads = 2}, {});
    std::vector<Bytes> third;
    for (std::size_t k = 2 * names.size(); k < all.files.size(); ++k) {
        third.push_back(read_file(all.files[k], kImageInput));
    }
    const BakeSummary alone = bake(preset, {.frames = {3}, .threads = 1}, {});
    ASSERT_EQ(alone.files.size(), names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        EXPECT_EQ(read_file(alone.files[k], kImageInput), third[k]) << names[k];
    }
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
        sizes.push_back(read_file(summary.files.front(), kImageInput).size());
        pictures.push_back(codes8(read_picture(summary.files.front())));
    }
    EXPECT_GT(sizes[0], sizes[1]);
    EXPECT_GT(sizes[1], sizes[2]);
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(Bake, ReportsProgressOncePerFrame) {
    const TemporaryFolder folder;
    std::vector<int> done;
    bake(small_preset(folder.path() / kPattern),
         {.frames = {1, 2, 3}, .threads = 2},
         {.on_progress = [&](const RunProgress& p) {
             if (p.phase == Phase::Frames && (done.empty() || done.back() != p.done)) {
                 done.push_back(p.done);
                 EXPECT_EQ(p.total, 3);
                 EXPECT_LT(p.angle_error, 1e-9);
             }
         }});
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3}));
}

TEST(Bake, RejectsInvalidFrames) {
    const TemporaryFolder folder;
    const Preset preset = small_preset(folder.path() / kPattern);
    EXPECT_THROW(check_bake(preset, {.frames = {}}), std::invalid_argument);
    EXPECT_THROW(check_bake(preset, {.frames = {0}}), std::invalid_argument);
    EXPECT_NO_THROW(check_bake(preset, {.frames = {1}}));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "deep"));
}

TEST(Bake, ReportsTheFolderThatCannotBeCreated) {
    const TemporaryFolder folder;
    write_file(folder.path() / "deep", {});  // a file has the name of the folder
    const auto run = [&] {
        bake(small_preset(folder.path() / kPattern), {.frames = {1}, .threads = 2}, {});
    };
    EXPECT_THROW(run(), OutputError);
    EXPECT_THROW(check_bake(small_preset(folder.path() / kPattern), {.frames = {1}}), OutputError);
}

}  // namespace
}  // namespace foam::texgen
