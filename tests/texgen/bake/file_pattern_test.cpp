// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/file_pattern.h"

#include "texgen/image/format.h"
#include "texgen/preset/preset.h"
#include "texgen/vector/format.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace foam::texgen {
namespace {

Preset preset_with(const std::string& pattern, const std::string& name = "sea") {
    Preset preset;
    preset.name = name;
    preset.output.pattern = pattern;
    return preset;
}

std::string filled(const std::string& pattern, int frame) {
    return FilePattern(preset_with(pattern)).path("albedo", frame).string();
}

std::string failure(const std::string& pattern, std::size_t frames = 1, std::size_t maps = 1) {
    try {
        FilePattern(preset_with(pattern)).check_distinct(frames, maps);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no failure";
}

TEST(FilePattern, FillsInNamesAndNumbers) {
    EXPECT_EQ(filled("out/{preset}_{map}.####.png", 7), "out/sea_albedo.0007.png");
    EXPECT_EQ(filled("{map}{map}.png", 7), "albedoalbedo.png");
}

TEST(FilePattern, DigitsFollowThePlaceholder) {
    EXPECT_EQ(filled("#.png", 12), "0012.png");  // a single # stands for four digits
    EXPECT_EQ(filled("##.png", 7), "07.png");
    EXPECT_EQ(filled("######.png", 7), "000007.png");
    EXPECT_EQ(filled("@.png", 7), "7.png");
    EXPECT_EQ(filled("@@@.png", 7), "007.png");
    EXPECT_EQ(filled("%04d.png", 7), "0007.png");
    EXPECT_EQ(filled("%d.png", 7), "7.png");
    EXPECT_EQ(filled("##/a.####.png", 7), "07/a.0007.png");
}

TEST(FilePattern, WiderNumbersAreWrittenInFull) {
    EXPECT_EQ(filled("##.png", 12345), "12345.png");
    EXPECT_EQ(filled("@.png", 10), "10.png");
    EXPECT_EQ(filled("%02d.png", 100), "100.png");
}

TEST(FilePattern, ASequenceKeepsThePlaceholder) {
    EXPECT_EQ(FilePattern(preset_with("{preset}/%04d_{map}.@@.png")).path_pattern("height"),
              "sea/%04d_height.@@.png");
}

TEST(FilePattern, NamesThatContainPlaceholdersAreNotExpanded) {
    EXPECT_EQ(FilePattern(preset_with("{preset}.#.png", "a{map}#")).path("m", 1).string(),
              "a{map}#.0001.png");
    EXPECT_EQ(filled("{preset}_{map}.#.png", 1), "sea_albedo.0001.png");
}

TEST(FilePattern, RejectsUnknownPlaceholdersAndOtherFormats) {
    EXPECT_EQ(
        failure("{mapp}.#.png"),
        "file name pattern '{mapp}.#.png': unknown placeholder '{mapp}'; did you mean {map}?");
    EXPECT_EQ(failure("a{map.png"),
              "file name pattern 'a{map.png': '{map.png' has no closing brace");
    for (const char* pattern : {"%s.png", "%4d.png", "%.png", "%012d.png", "a%.png", "%0xd.png"}) {
        EXPECT_NE(failure(pattern), "no failure") << pattern;
    }
    EXPECT_EQ(failure("a.####.jpg"),
              "file name pattern 'a.####.jpg': must end in " + format_suffixes() + ", or in " +
                  vector_suffixes() + "; an example is 'x/{map}.####.png'");
}

TEST(FilePattern, TwoImagesMayNotShareAFile) {
    EXPECT_EQ(failure("a.png"), "no failure");
    EXPECT_EQ(
        failure("{map}.png", 48),
        "file name pattern '{map}.png': must contain a frame number (####, @@@@ or %04d) for 48 "
        "frames");
    EXPECT_EQ(failure("####.png", 48, 2),
              "file name pattern '####.png': must contain {map} for 2 maps");
    EXPECT_EQ(failure("{map}.@.png", 48, 2), "no failure");
}

// The channels of an EXR have names, so maps can share a file. The channels of a PNG have no names.
TEST(FilePattern, OnlyAnExrHoldsSeveralMaps) {
    EXPECT_EQ(FilePattern("a.exr").format().name, "EXR");
    EXPECT_EQ(FilePattern("a.png").format().name, "PNG");
    EXPECT_TRUE(FilePattern("a.exr").stores_all_maps_in_one_file());
    EXPECT_FALSE(FilePattern("a_{map}.exr").stores_all_maps_in_one_file());
    EXPECT_FALSE(FilePattern("a.png").stores_all_maps_in_one_file());
    EXPECT_NO_THROW(FilePattern("a.exr").check_distinct(1, 3));
    EXPECT_THROW(FilePattern("a.exr").check_distinct(2, 3), std::invalid_argument);
    EXPECT_THROW(FilePattern("a.png").check_distinct(1, 3), std::invalid_argument);
}

// The result does not depend on which maps and frames are baked.
TEST(FilePattern, FilesAreInTheDeepestFolderThatHoldsThemAll) {
    const auto folder = [](const char* pattern) {
        return FilePattern(preset_with(pattern, "foam")).folder().string();
    };
    EXPECT_EQ(folder("out/{preset}_{map}.####.png"), "out");
    EXPECT_EQ(folder("out/{preset}/{map}/####.png"), "out/foam");
    EXPECT_EQ(folder("/a/b####/{map}.png"), "/a");
    EXPECT_EQ(folder("/####.png"), "/");
    EXPECT_EQ(folder("####.png"), "");
    EXPECT_EQ(folder("deep/a.png"), "deep");
    EXPECT_EQ(folder("out/{size}/{seed}_{map}.png"), "out/1024");
}

// The values of a preset are known before the bake, so a pattern replaces them at once.
TEST(FilePattern, FillsInValuesOfThePreset) {
    Preset preset = preset_with("out/{seed}/{size}_{foam.bubbles}_{map}.####.png");
    preset.seeding.seed = 7;
    preset.seeding.bubbles = 150;
    preset.image.width = 64;
    preset.image.height = 32;
    const FilePattern pattern(preset);
    EXPECT_EQ(pattern.path("lit", 3), "out/7/64x32_150_lit.0003.png");
    EXPECT_EQ(pattern.path_pattern("lit"), "out/7/64x32_150_lit.####.png");
    EXPECT_EQ(pattern.folder(), "out/7");
}

TEST(FilePattern, ValuesDoNotTellFramesOrMapsApart) {
    EXPECT_NE(failure("{seed}.png", 2), "no failure");
    EXPECT_NE(failure("{size}.####.png", 2, 2), "no failure");
}

// The period in a placeholder or in its value does not begin the suffix.
TEST(FilePattern, TablesAddTheirNameBeforeTheFirstPeriodOutsideOfBraces) {
    EXPECT_EQ(filled("a.####.csv", 1), "a_albedo.0001.csv");
    EXPECT_EQ(filled("{loop.amplitude}.####.csv", 1), "0.15_albedo.0001.csv");
    EXPECT_EQ(filled("x{loop.amplitude}.csv", 1), "x0.15_albedo.csv");
    EXPECT_EQ(filled(".hidden.csv", 1), ".hidden_albedo.csv");
    EXPECT_NE(failure("a{loop.csv"), "no failure");
}

TEST(FilePattern, WithoutAPresetOnlyTheMapIsAPlaceholder) {
    EXPECT_EQ(FilePattern("{map}.####.png").path("id", 2), "id.0002.png");
    try {
        FilePattern("{preset}.####.png");
        FAIL() << "accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_STREQ(error.what(),
                     "file name pattern '{preset}.####.png': unknown placeholder '{preset}'; must "
                     "be {map}");
    }
}

TEST(WithSizeFolder, AddsAFolderAboveAllMapsAndFrames) {
    EXPECT_EQ(with_size_folder("out/{preset}_{map}.####.png"),
              "out/{size}/{preset}_{map}.####.png");
    EXPECT_EQ(with_size_folder("out/{map}/####.png"), "out/{size}/{map}/####.png");
    EXPECT_EQ(with_size_folder("a/b%04d/{map}.png"), "a/{size}/b%04d/{map}.png");
    EXPECT_EQ(with_size_folder("{preset}/a.png"), "{preset}/{size}/a.png");
    EXPECT_EQ(with_size_folder("/####.png"), "/{size}/####.png");
    EXPECT_EQ(with_size_folder("####.png"), "{size}/####.png");
    EXPECT_EQ(with_size_folder("out/{map}_{size}.png"), "out/{map}_{size}.png");
}

TEST(WithoutSharedFolders, KeepsFoldersOfMapsAndFrames) {
    EXPECT_EQ(without_shared_folders("out/{preset}_{map}.####.png"), "{preset}_{map}.####.png");
    EXPECT_EQ(without_shared_folders("out/{map}/####.png"), "{map}/####.png");
    EXPECT_EQ(without_shared_folders("/a/{preset}/b%04d/{map}.png"), "b%04d/{map}.png");
    EXPECT_EQ(without_shared_folders("a/b.svg"), "b.svg");
    EXPECT_EQ(without_shared_folders("####.png"), "####.png");
}

}  // namespace
}  // namespace foam::texgen
