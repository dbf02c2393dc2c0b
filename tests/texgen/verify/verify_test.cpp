// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/verify.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/pictures.h"
#include "tests/texgen/small_preset.h"
#include "tests/texgen/verify/breathing_loop.h"
#include "texgen/bake/frame_range.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/image/png.h"
#include "texgen/manifest/manifest_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns the result for the only set of a folder.
VerifiedSet verified(const std::filesystem::path& folder) {
    Verification found = verify(folder);
    EXPECT_EQ(found.sets.size(), 1U);
    return std::move(found.sets.front());
}

using Change = void (*)(Image<std::uint8_t>&);

/// Changes an image, and its hash in the manifest, as if it had been baked with this change.
void change_baked_image(const std::filesystem::path& folder,
                        const std::string& name,
                        Change change) {
    Image<std::uint8_t> image = codes8(read_picture(folder / name));
    change(image);
    write_png(folder / name, std::as_const(image).view());
    update_manifest(folder, [&](Manifest& manifest) {
        for (ManifestFile& file : manifest.sets.front().files) {
            file.pixels = file.path == name ? pixel_hash(read_picture(folder / name)) : file.pixels;
        }
    });
}

// A flow closes although the foam never returns to its first state.
TEST(Verify, AFlowClosesByItsCrossFade) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.loop = {.kind = LoopKind::Flow, .fade = 0.5, .growth = 6};
    preset.image.maps = {"albedo", "height", "normal", "motion"};
    preset.frames.count = 24;
    preset.frames.time_step = 4.0;
    preset.frames.warm_up = 40.0;
    bake_small(preset, frames_to(24));
    const VerifiedSet found = verified(folder.path());
    EXPECT_EQ(found.problems, std::vector<std::string>{});
    EXPECT_TRUE(found.set.loop.cross_faded);
    EXPECT_EQ(found.set.loop.kind, "flow");
    ASSERT_EQ(found.maps.size(), 4U);
    for (const VerifiedMap& map : found.maps) {
        ASSERT_TRUE(map.loop) << map.name;
        EXPECT_LE(map.loop->ratio(), 1.1) << map.name;
    }
}

TEST(Verify, AcceptsABakedLoop) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), frames_to(8));
    const VerifiedSet found = verified(folder.path());
    EXPECT_EQ(found.problems, std::vector<std::string>{});
    EXPECT_EQ(found.files_same, 24);
    ASSERT_EQ(found.maps.size(), 3U);
    for (const VerifiedMap& map : found.maps) {
        ASSERT_TRUE(map.tile && map.loop) << map.name;
        EXPECT_GT(map.tile->ratio(), 0.1) << map.name;
        EXPECT_GT(map.loop->ratio(), 0.1) << map.name;
        EXPECT_LE(map.loop->ratio(), 1.1) << map.name;
    }
}

TEST(Verify, LayersOfAnExrAreChecked) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.output.pattern = (folder.path() / "all.####.exr").string();
    bake_small(preset, frames_to(8));
    const VerifiedSet found = verified(folder.path());
    EXPECT_TRUE(found.holds());
    EXPECT_EQ(found.files_same, 8);
    ASSERT_EQ(found.maps.size(), 3U);
    EXPECT_NE(found.maps[0].tile->across, found.maps[1].tile->across);
    EXPECT_TRUE(found.maps[2].loop);
}

TEST(Verify, ReportsMissingDamagedAndChangedFiles) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), {1, 2, 3});
    std::filesystem::remove(folder.path() / "id.0001.png");
    write_file(folder.path() / "id.0002.png", {});
    Image<std::uint8_t> image = codes8(read_picture(folder.path() / "albedo.0003.png"));
    image.samples()[100] ^= 1U;
    write_png(folder.path() / "albedo.0003.png", std::as_const(image).view());
    const VerifiedSet found = verified(folder.path());
    EXPECT_EQ(found.files_same, 6);
    ASSERT_EQ(found.problems.size(), 3U);
    EXPECT_NE(found.problems[0].find("id.0001.png': No such file"), std::string::npos);
    EXPECT_NE(found.problems[1].find("id.0002.png': malformed PNG"), std::string::npos);
    EXPECT_EQ(found.problems[2],
              "albedo.0003.png: the pixels differ from the baked pixels (their hash differs from "
              "the hash in the manifest)");
}

// A PNG with another compression and other texts has the same pixels.
TEST(Verify, AcceptsARecompressedPicture) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), {1});
    const std::filesystem::path path = folder.path() / "albedo.0001.png";
    write_png(path, codes8(read_picture(path)).view(), {}, {.compression = Compression::Small});
    EXPECT_TRUE(verified(folder.path()).holds());
}

// The right half of the image is replaced by other pixels of the image, mirrored. They do not match
// at the border.
TEST(Verify, FindsAnImageThatDoesNotTile) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), {1, 2});
    change_baked_image(folder.path(), "albedo.0002.png", [](Image<std::uint8_t>& image) {
        const int width = image.width();
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; 2 * x < width; ++x) {
                std::ranges::copy(image.pixel((x + 20) % width, y),
                                  image.pixel(width - 1 - x, y).begin());
            }
        }
    });
    const VerifiedSet found = verified(folder.path());
    EXPECT_EQ(found.maps.front().tile_frame, 2);
    ASSERT_EQ(found.problems.size(), 1U);
    EXPECT_EQ(found.problems[0].find("albedo: frame 2 does not tile: "), 0U);
}

// The 8 frames are half of the period. They are not a loop, and the manifest is changed to claim
// that they are.
TEST(Verify, FindsALoopThatJumps) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.frames.count = 16;
    bake_small(preset, frames_to(8));
    EXPECT_TRUE(verified(folder.path()).holds());
    update_manifest(folder.path(),
                    [](Manifest& manifest) { manifest.sets.front().loop.period = 8; });
    const VerifiedSet found = verified(folder.path());
    for (const VerifiedMap& map : found.maps) {
        EXPECT_GT(map.loop->ratio(), 1.5) << map.name;
    }
    ASSERT_EQ(found.problems.size(), 3U);
    EXPECT_EQ(found.problems[0].find("albedo: does not loop: "), 0U);
}

// A pixel changes like a sine. Its largest step is the one from the last frame to the first.
TEST(Verify, TheLimitOfALoopAllowsPixelsThatChangeLikeASine) {
    for (const int period : {5, 7, 9, 15, 47}) {
        const auto value = [&](int frame) {
            return std::sin(2.0 * std::numbers::pi * (frame + 0.5) / period);
        };
        double largest_within = 0.0;
        for (int frame = 0; frame + 1 < period; ++frame) {
            largest_within = std::max(largest_within, std::abs(value(frame + 1) - value(frame)));
        }
        const double across = std::abs(value(0) - value(period - 1));
        EXPECT_GT(across, largest_within) << period;
        EXPECT_LT(across / largest_within, largest_loop_ratio(period)) << period;
    }
    EXPECT_LT(largest_loop_ratio(48), 1.11);
}

TEST(Verify, ALoopOfLessThanFiveFramesIsNotChecked) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.frames.count = 4;
    bake_small(preset, frames_to(4));
    const VerifiedSet found = verified(folder.path());
    EXPECT_TRUE(found.holds());
    EXPECT_FALSE(found.maps.front().loop);
    EXPECT_NE(to_text(verify(folder.path())).find("not checked: needs a loop of at least 5 frames"),
              std::string::npos);
}

TEST(Verify, ALoopIsCheckedOnlyAsAWhole) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), {1, 2, 3, 4, 5, 6, 7});
    const VerifiedSet found = verified(folder.path());
    EXPECT_TRUE(found.holds());
    EXPECT_FALSE(found.maps.front().loop);
    EXPECT_NE(to_text(verify(folder.path())).find("not checked: needs frames 1 to 8"),
              std::string::npos);
}

// Frames 9 and 10 belong to the next period of the loop.
TEST(Verify, IgnoresFramesAfterThePeriodOfALoop) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), frames_to(10));
    const VerifiedSet found = verified(folder.path());
    EXPECT_EQ(found.problems, std::vector<std::string>{});
    const TemporaryFolder other;
    bake_small(breathing_loop(other.path()), frames_to(8));
    const VerifiedSet period = verified(other.path());
    for (std::size_t k = 0; k < found.maps.size(); ++k) {
        ASSERT_TRUE(found.maps[k].loop) << found.maps[k].name;
        EXPECT_EQ(found.maps[k].loop->across, period.maps[k].loop->across);
        EXPECT_EQ(found.maps[k].loop->largest_within, period.maps[k].loop->largest_within);
    }
}

// A file of another size, as if the manifest had been edited: the steps to and from it are
// infinite.
TEST(Verify, FindsALoopOfFramesThatDifferInSize) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), frames_to(8));
    change_baked_image(folder.path(), "albedo.0001.png", [](Image<std::uint8_t>& image) {
        image = Image<std::uint8_t>(image.width() / 2, image.height(), image.channels());
    });
    const VerifiedSet found = verified(folder.path());
    EXPECT_FALSE(found.maps.front().holds(8));
    ASSERT_EQ(found.problems.size(), 1U);
    EXPECT_EQ(found.problems[0].find("albedo: does not loop: "), 0U);
}

TEST(Verify, ReportsMissingFramesOfAFailedBake) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), {1, 2, 3});
    update_manifest(folder.path(), [](Manifest& manifest) {
        BakedSet& set = manifest.sets.front();
        std::erase_if(set.files, [](const ManifestFile& file) { return file.frame > 1; });
        set.failure = "no space left";
    });
    EXPECT_EQ(
        verified(folder.path()).problems,
        std::vector<std::string>{"albedo, height, id: frames 2-3 are missing: no space left"});
}

TEST(Verify, APatchIsNoTile) {
    const TemporaryFolder folder;
    Preset preset = breathing_loop(folder.path());
    preset.shape.kind = FoamKind::Patch;
    preset.loop.kind = LoopKind::None;
    bake_small(preset, {1, 2});
    const VerifiedSet found = verified(folder.path());
    EXPECT_TRUE(found.holds());
    EXPECT_FALSE(found.maps.front().tile);
}

TEST(Verify, RejectsAFolderWithoutImages) {
    const TemporaryFolder folder;
    EXPECT_THROW(verify(folder.path()), InputError);
    update_manifest(folder.path(), [](Manifest&) {});
    EXPECT_FALSE(verify(folder.path()).holds());
}

TEST(Verify, CountsEveryFileEvenIfItIsBad) {
    const TemporaryFolder folder;
    bake_small(breathing_loop(folder.path()), frames_to(2));
    std::filesystem::remove(folder.path() / "id.0002.png");
    std::vector<int> done;
    verify(folder.path(), [&](const RunProgress& progress) {
        EXPECT_EQ(progress.phase, Phase::Files);
        EXPECT_EQ(progress.total, 6);
        done.push_back(progress.done);
    });
    EXPECT_EQ(done, (std::vector<int>{0, 1, 2, 3, 4, 5, 6}));
}

}  // namespace
}  // namespace foam::texgen
