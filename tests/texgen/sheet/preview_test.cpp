// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/preview.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/image/png_chunks.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/sheet/small_bake.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

Names write(const BakedSet& set, const TemporaryFolder& folder, const PreviewOptions& options) {
    Names names;
    for (const auto& path : write_previews(set, folder.path(), options, folder.path() / "shown")) {
        EXPECT_TRUE(std::filesystem::exists(path));
        names.push_back(path.filename().string());
    }
    return names;
}

TEST(Preview, PrefersMapsForTheEye) {
    const TemporaryFolder folder;
    const BakedSet tile = baked(small_loop(folder.path()), {"id", "height", "albedo"});
    EXPECT_EQ(
        write(tile, folder, {}),
        (Names{"small_albedo_contact.png", "small_albedo_loop.png", "small_albedo_tiling.png"}));
    const TemporaryFolder other;
    const BakedSet patch = baked(small_patch(other.path()), {"id", "height"});
    EXPECT_EQ(write(patch, other, {}),
              (Names{"small_height_contact.png", "small_height_loop.png"}));
}

// Bakes a preset to files with this extension. Returns the contact sheet of a map. In an EXR, the
// map is one of two layers.
Image<std::uint8_t> contact_of(Preset preset, const char* extension, const std::string& map) {
    const TemporaryFolder folder;
    const bool is_exr = std::string_view(extension) == ".exr";
    const char* const stem = is_exr ? "{preset}.####" : "{preset}_{map}.####";
    preset.output.pattern = (folder.path() / stem).string() + extension;
    const BakedSet set = baked(preset, {"film", map});
    write(set, folder, {.maps = {map}, .kinds = {PreviewKind::Contact}});
    return codes8(read_picture(folder.path() / "shown" / ("small_" + map + "_contact.png")));
}

int largest_difference(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b) {
    int largest = a.samples().size() == b.samples().size() ? 0 : 255;
    for (std::size_t k = 0; k < std::min(a.samples().size(), b.samples().size()); ++k) {
        largest = std::max(largest, std::abs(a.samples()[k] - b.samples()[k]));
    }
    return largest;
}

// A PNG is rounded once more than an EXR, so the previews may differ by one code of 255. In albedo
// of a patch, the opacity in a PNG is rounded by up to half of 1/255. A pale film then changes the
// light over the dark ground by 0.002, which is 1.8 codes there.
TEST(Preview, ShowsAnExrAsItWouldAPng) {
    const TemporaryFolder folder;
    for (const std::string map : {"albedo", "opacity", "height", "normal", "motion", "growth"}) {
        for (Preset preset : {small_loop(folder.path()), small_patch(folder.path())}) {
            // Automatic ranges are fitted only for files of codes.
            preset.maps.height.full = {0.5};
            preset.maps.motion.multiplier = {0.02};
            preset.maps.growth.full = {0.05};
            const bool is_clear = preset.shape.kind == FoamKind::Patch && map == "albedo";
            const Image<std::uint8_t> png = contact_of(preset, ".png", map);
            EXPECT_LE(largest_difference(contact_of(preset, ".exr", map), png), is_clear ? 2 : 1)
                << map;
        }
    }
}

TEST(Preview, TilesAFrame) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    write(set, folder, {.frames = {3}, .kinds = {PreviewKind::Tiling}});
    const auto frame = codes8(read_picture(folder.path() / "small_albedo.0003.png"));
    const auto tiling = codes8(read_picture(folder.path() / "shown" / "small_albedo_tiling.png"));
    ASSERT_EQ(tiling.width(), 64);
    ASSERT_EQ(tiling.height(), 48);
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 64; ++x) {
            EXPECT_TRUE(std::ranges::equal(tiling.pixel(x, y), frame.pixel(x % 32, y % 24)));
        }
    }
}

// Frames that are small enough keep their size. The first frame has the same samples as its PNG.
TEST(Preview, AnimatesEveryFrame) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    write(set, folder, {.kinds = {PreviewKind::Loop}});
    const Bytes stream = read_file(folder.path() / "shown" / "small_albedo_loop.png", kImageInput);
    EXPECT_EQ(codes8(decode_png(stream)),
              codes8(read_picture(folder.path() / "small_albedo.0001.png")));
    EXPECT_EQ(chunk(stream, "acTL"), std::string("\0\0\0\4\0\0\0\0", 8));
    EXPECT_EQ(chunk(stream, "fcTL").substr(20, 4), std::string("\0\1\0\x18", 4));  // 1/24 s
}

TEST(Preview, KeepsItsSpeedWithFewerFrames) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    write(set, folder, {.frames = {1, 3}, .kinds = {PreviewKind::Loop}});
    const Bytes stream = read_file(folder.path() / "shown" / "small_albedo_loop.png", kImageInput);
    EXPECT_EQ(chunk(stream, "fcTL").substr(20, 4), std::string("\0\2\0\x18", 4));  // 2/24 s
}

TEST(Preview, IsTheSameForAnyNumberOfThreads) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo"});
    const std::filesystem::path path = folder.path() / "shown" / "small_albedo_loop.png";
    write(set, folder, {.kinds = {PreviewKind::Loop}, .size = 20, .threads = 1});
    const Bytes one = read_file(path, kImageInput);
    write(set, folder, {.kinds = {PreviewKind::Loop}, .size = 20, .threads = 3});
    EXPECT_EQ(read_file(path, kImageInput), one);
    EXPECT_EQ(codes8(decode_png(one)).width(), 20);
    EXPECT_EQ(codes8(decode_png(one)).height(), 15);
}

TEST(Preview, RejectsMapsThatCannotBeShown) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_patch(folder.path()), {"id"});
    EXPECT_THROW(write(set, folder, {}), std::invalid_argument);
    EXPECT_THROW(write(set, folder, {.maps = {"id"}}), std::invalid_argument);
    const BakedSet more = baked(small_patch(folder.path()), {"height"});
    EXPECT_THROW(write(more, folder, {.maps = {"height"}, .kinds = {PreviewKind::Tiling}}),
                 std::invalid_argument);
    const std::vector<PreviewKind> kinds{PreviewKind::Contact, PreviewKind::Tiling};
    EXPECT_THROW(write(more, folder, {.maps = {"height"}, .kinds = kinds}), std::invalid_argument);
    EXPECT_THROW(write(more, folder, {.maps = {"height", "id"}}), std::invalid_argument);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "shown"));  // nothing was written
}

// The first map of the set has no files yet, the second one has only drawings.
TEST(Preview, RejectsDrawings) {
    const TemporaryFolder folder;
    BakedSet set = baked(small_loop(folder.path()), {"albedo", "height"});
    set.maps[0].samples.reset();
    set.maps[1].samples.reset();
    set.maps[1].vector_format = "SVG";
    const auto failure = [&] {
        try {
            write(set, folder, {});
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string("no failure");
    };
    EXPECT_EQ(failure(),
              "'height' is in SVG files, which have no pixels; bake PNG or EXR files instead");
    set.maps.clear();
    EXPECT_EQ(failure(), "no map of preset 'small' was baked");
}

TEST(Preview, CountsAsManyPicturesAsItAnnounces) {
    const TemporaryFolder folder;
    const BakedSet set = baked(small_loop(folder.path()), {"albedo", "height"});
    std::vector<int> done;
    int total = 0;
    write_previews(set,
                   folder.path(),
                   {.maps = {"albedo", "height"}, .threads = 2},
                   folder.path() / "shown",
                   [&](const RunProgress& progress) {
                       EXPECT_EQ(progress.phase, Phase::Previews);
                       done.push_back(progress.done);
                       total = progress.total;
                   });
    // For each map: three files, four thumbnails, and four frames of an animation that are reduced
    // and then encoded.
    EXPECT_EQ(total, 2 * (3 + 4 + 2 * 4));
    ASSERT_EQ(done.size(), static_cast<std::size_t>(total) + 1U);
    for (int k = 0; k <= total; ++k) {
        EXPECT_EQ(done.at(static_cast<std::size_t>(k)), k);
    }
}

}  // namespace
}  // namespace foam::texgen
