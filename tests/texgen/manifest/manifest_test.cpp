// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/manifest.h"

#include "tests/texgen/manifest/small_set.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

TEST(Manifest, ASetIsCompleteOnceEveryFrameOfEveryMapExists) {
    EXPECT_TRUE(small_set("a", {1, 2}, {1, 2}).complete());
    EXPECT_FALSE(small_set("a", {1, 2}, {2}).complete());
    BakedSet set = small_set("a", {1}, {1});
    set.maps.push_back({"film", "mask", "0 to 1", "", {1}, {}});
    EXPECT_FALSE(set.complete());
    set.files.front().maps = {"height", "film"};  // layers of an EXR
    EXPECT_TRUE(set.complete());
    EXPECT_EQ(set.find_file("film", 1), &set.files.front());
    EXPECT_EQ(set.find_file("film", 2), nullptr);
    EXPECT_EQ(set.find_map("age"), nullptr);
}

// Several machines may bake frames of one preset into one folder.
TEST(Manifest, FramesOfTheSameParametersBecomeOneSet) {
    Manifest manifest;
    merge(manifest, small_set("a", {3, 4}, {3, 4}));
    merge(manifest, small_set("a", {1, 2}, {1}));
    ASSERT_EQ(manifest.sets.size(), 1U);
    EXPECT_FALSE(manifest.sets.front().complete());
    merge(manifest, small_set("a", {1, 2}, {1, 2}));
    EXPECT_EQ(manifest.sets, std::vector{small_set("a", {1, 2, 3, 4}, {1, 2, 3, 4})});
}

TEST(Manifest, MapsOfTheSameParametersBecomeOneSet) {
    Manifest manifest;
    merge(manifest, small_set("a", {1, 2}, {1, 2}));
    BakedSet film = small_set("a", {2}, {2});
    film.maps.front().name = "film";
    film.files.front().maps = {"film"};
    film.files.front().path = "a_film.2.png";
    merge(manifest, film);
    ASSERT_EQ(manifest.sets.size(), 1U);
    const BakedSet& set = manifest.sets.front();
    EXPECT_TRUE(set.complete());
    EXPECT_EQ(set.frames(), (std::vector{1, 2}));
    EXPECT_EQ(set.files.size(), 3U);
    EXPECT_EQ(set.frame_statistics.size(), 2U);
    EXPECT_EQ(set.find_file("film", 2)->path, "a_film.2.png");
}

// Automatic ranges are not fitted before the first file is written. Until then, the note and the
// motion multiplier of a bake say nothing about the existing files.
TEST(Manifest, ABakeThatWritesNoFileKeepsTheNotesAndTheConventions) {
    Manifest manifest;
    BakedSet written = small_set("a", {1}, {1});
    written.maps.front().name = "motion";
    written.maps.front().note = "the largest code is 0.2";
    written.conventions.motion_multiplier = 0.2;
    written.files.front().maps = {"motion"};
    merge(manifest, written);
    BakedSet later = written;
    later.files.clear();
    later.maps.front().samples.reset();
    later.maps.front().note = "the largest code is 0.005";
    later.conventions.motion_multiplier = 0.005;
    merge(manifest, later);
    EXPECT_EQ(manifest.sets, std::vector{written});
    later.maps.front().samples = written.maps.front().samples;
    merge(manifest, later);
    EXPECT_EQ(manifest.sets.front().maps, later.maps);
    EXPECT_EQ(manifest.sets.front().conventions, later.conventions);
}

// A file that is overwritten belongs to the set of the later bake. A set that has no files left is
// removed.
TEST(Manifest, FilesBelongToTheirLastWriter) {
    Manifest manifest;
    merge(manifest, small_set("a", {1, 2}, {1, 2}));
    merge(manifest, small_set("b", {1}, {1}));
    EXPECT_EQ(manifest.sets.size(), 2U);
    BakedSet other = small_set("a", {1}, {1});
    other.parameters = "other";
    merge(manifest, other);
    ASSERT_EQ(manifest.sets.size(), 3U);
    EXPECT_EQ(manifest.sets.front().files.size(), 1U);
    EXPECT_FALSE(manifest.sets.front().complete());
    other = small_set("a", {1, 2}, {1, 2});
    other.parameters = "other";
    merge(manifest, other);
    EXPECT_EQ(manifest.sets.size(), 2U);
}

// The bake that wrote last is the last set, also if it added to an older set.
TEST(Manifest, TheSetThatWasMergedLastIsTheLastOne) {
    Manifest manifest;
    merge(manifest, small_set("a", {1}, {1}));
    merge(manifest, small_set("b", {1}, {1}));
    merge(manifest, small_set("c", {1}, {1}));
    merge(manifest, small_set("a", {2}, {2}));
    ASSERT_EQ(manifest.sets.size(), 3U);
    EXPECT_EQ(manifest.sets[0].preset, "b");
    EXPECT_EQ(manifest.sets[1].preset, "c");
    EXPECT_EQ(manifest.sets[2].preset, "a");
}

TEST(Manifest, CountsFilesOfOtherSetsThatAreReplaced) {
    const Manifest manifest{{small_set("a", {1, 2}, {1, 2}), small_set("b", {1}, {1})}};
    const std::vector<ReplacedFiles> replaced =
        replaced_files(manifest, "of b", {"a_height.1.png", "b_height.1.png", "new.png"});
    ASSERT_EQ(replaced.size(), 1U);
    EXPECT_EQ(replaced.front().set, &manifest.sets.front());
    EXPECT_EQ(replaced.front().count, 1U);
}

// A scene file belongs to the set that wrote it last. Baking more frames keeps the scene files.
TEST(Manifest, SceneFilesBelongToTheirLastWriter) {
    Manifest manifest = small_manifest();
    const std::string first = manifest.sets[0].parameters;
    const std::string second = manifest.sets[1].parameters;
    ASSERT_NE(first, second);
    const ManifestScene scene{"a.usda", "usda", 7, "xyz"};
    add_scenes(manifest, first, {scene});
    ASSERT_EQ(manifest.sets[0].scenes.size(), 2U);
    EXPECT_EQ(manifest.sets[0].scenes.back(), scene);
    add_scenes(manifest, second, {scene});
    EXPECT_EQ(manifest.sets[0].scenes.size(), 1U);
    EXPECT_EQ(manifest.sets[1].scenes, std::vector{scene});
    add_scenes(manifest, "other", {scene});
    EXPECT_EQ(manifest.sets[1].scenes, std::vector{scene});
    BakedSet more = manifest.sets[1];
    more.scenes.clear();
    merge(manifest, more);
    EXPECT_EQ(manifest.sets.back().scenes, std::vector{scene});
}

TEST(Manifest, AFailureIsKeptUntilTheSetIsComplete) {
    Manifest manifest;
    BakedSet broken = small_set("a", {1, 2}, {1});
    broken.failure = "frame 2: the foam did not reach equilibrium";
    merge(manifest, broken);
    EXPECT_EQ(manifest.sets.front().failure, broken.failure);
    merge(manifest, small_set("a", {2}, {2}));
    EXPECT_EQ(manifest.sets.front().failure, "");
}

}  // namespace
}  // namespace foam::texgen
