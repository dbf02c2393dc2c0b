// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/map_sequence.h"

#include "core/files/file_io.h"
#include "tests/texgen/manifest/small_set.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(MapSequence, HasAFileForEachFrame) {
    const BakedSet set = small_set("a", {1, 2, 3}, {1, 3});
    const MapSequence sequence = map_sequence(set, "out", "height", std::vector{3, 1});
    ASSERT_EQ(sequence.files.size(), 2U);
    EXPECT_EQ(sequence.files[0].path, std::filesystem::path("out") / "a_height.3.png");
    EXPECT_EQ(sequence.files[0].frame, 3);
    EXPECT_FALSE(sequence.files[0].layered);
    EXPECT_TRUE(sequence.tiles());
    EXPECT_THROW(map_sequence(set, "out", "height", std::vector{2}), InputError);
    EXPECT_THROW(map_sequence(set, "out", "egg", std::vector{1}), std::invalid_argument);
}

// Returns the message about a map that has no files.
std::string error_of(std::string_view map) {
    const BakedSet set = small_manifest().sets[1];
    try {
        map_sequence(set, "out", map, std::vector{7});
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

// Frame 2 of the set belongs to another bake.
TEST(MapSequence, RejectsAFrameWithoutAFileAndNamesTheOthers) {
    const BakedSet set = small_set("a", {1, 2, 3}, {1, 3});
    try {
        map_sequence(set, "out", "height", std::vector{2});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "frame 2 of map 'height' of preset 'a' was not baked into 'out', or another "
                     "bake has replaced it; existing frames: 1,3");
    }
}

// The map "film" was requested, but none of its files was written.
TEST(MapSequence, RejectsAMapWithoutFilesAndNamesTheOthers) {
    EXPECT_EQ(error_of("film"), "map 'film' was not baked; baked maps: height");
    EXPECT_EQ(error_of("hieght"),
              "map 'hieght' was not baked; baked maps: height; did you mean 'height'?");
}

TEST(MapSequence, FramesWithACommonStepKeepTheirSpeed) {
    EXPECT_EQ(common_step(std::vector{1, 3, 5}), 2);
    EXPECT_EQ(common_step(std::vector{5, 4, 3}), -1);
    EXPECT_EQ(common_step(std::vector{4}), 1);
    EXPECT_FALSE(common_step(std::vector{1, 2, 4}));
    EXPECT_FALSE(common_step(std::vector{2, 2, 2}));
    const BakedSet set = small_set("a", {1}, {1});
    EXPECT_EQ(playing_rate(set, std::vector{1, 3}), (FrameRate{24, 2}));
    EXPECT_EQ(playing_rate(set, std::vector{1, 2, 4}), (FrameRate{24, 1}));
    EXPECT_EQ(playing_rate(set, std::vector{2, 2, 2}), (FrameRate{24, 1}));
}

}  // namespace
}  // namespace foam::texgen
