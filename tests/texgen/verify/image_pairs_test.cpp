// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/image_pairs.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/manifest/small_set.h"
#include "texgen/manifest/manifest_json.h"

#include <gtest/gtest.h>

#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

class ImagePairs : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

    /// Creates empty files in a folder.
    void add(const std::string& folder, const std::vector<std::string>& files) {
        for (const std::string& file : files) {
            const std::filesystem::path full = folder_.path() / folder / file;
            make_folders(full.parent_path());
            write_file(full, {});
        }
    }

    void add_manifest(const std::string& folder, const BakedSet& set) {
        make_folders(folder_.path() / folder);
        const std::string text = to_json(Manifest{{set}});
        write_file(folder_.path() / folder / "manifest.json", std::as_bytes(std::span(text)));
    }

    /// Returns the pairs as texts: "= name of b" for a pair, "- name of a" for an image that exists
    /// only in a, and "+ name of b" for an image that exists only in b.
    std::vector<std::string> pairs(const std::string& a,
                                   const std::string& b,
                                   const std::optional<std::string>& frames = {}) {
        std::vector<std::string> texts;
        for (const ImagePair& pair : image_pairs(path(a), path(b), frames)) {
            const bool only_a = pair.presence == Presence::OnlyA;
            const char* const sign =
                pair.presence == Presence::Both ? "= " : (only_a ? "- " : "+ ");
            texts.push_back(
                sign +
                (only_a ? pair.a : pair.b).lexically_relative(folder_.path()).generic_string());
        }
        return texts;
    }

    TemporaryFolder folder_;
};

using Texts = std::vector<std::string>;

TEST_F(ImagePairs, TwoNamesAreOnePair) {
    EXPECT_EQ(pairs("a.png", "b.png"), Texts{"= b.png"});
    add("", {"a@2x.png"});
    EXPECT_EQ(pairs("a@2x.png", "b.png"), Texts{"= b.png"});
}

TEST_F(ImagePairs, PatternsPairAllExistingFrames) {
    add("a", {"x.0001.png", "x.0002.png", "x.0010.png"});
    add("b", {"y2.png", "y3.png", "y10.png"});
    EXPECT_EQ(pairs("a/x.####.png", "b/y%d.png"),
              (Texts{"- a/x.0001.png", "= b/y2.png", "+ b/y3.png", "= b/y10.png"}));
    EXPECT_EQ(image_pairs(path("a/x.####.png"), path("b/y%d.png"), {}).front().frame, 1);
    EXPECT_EQ(image_pairs(path("a/x.####.png"), path("b/y%d.png"), {}).front().b, path("b/y1.png"));
}

TEST_F(ImagePairs, ARangeNamesFramesThatNeedNotExist) {
    EXPECT_EQ(pairs("a.####.png", "b.####.png", "2-3"), (Texts{"= b.0002.png", "= b.0003.png"}));
    EXPECT_THROW(pairs("a.png", "b.####.png", "2-3"), std::invalid_argument);
}

TEST_F(ImagePairs, FoldersPairAllImagesOfTheSameName) {
    add("a", {"x.png", "sub/y.exr", "only_a.png", "notes.txt"});
    add("b", {"x.png", "sub/y.exr", "sub/only_b.png", "notes.txt"});
    EXPECT_EQ(pairs("a", "b"),
              (Texts{"- a/only_a.png", "+ b/sub/only_b.png", "= b/sub/y.exr", "= b/x.png"}));
    EXPECT_EQ(pairs("a/", "b/"), pairs("a", "b"));
}

TEST_F(ImagePairs, ManifestsOfFoldersNameMapsAndFrames) {
    add("a", {"p_height.3.png", "other.png"});
    add("b", {"p_height.3.png"});
    add_manifest("b", small_set("p", {3}, {3}));
    const std::vector<ImagePair> found = image_pairs(path("a"), path("b"), {});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].map, "");
    EXPECT_FALSE(found[0].frame.has_value());
    EXPECT_EQ(found[1].map, "height");
    EXPECT_EQ(found[1].frame, 3);
}

// The manifest gives an image of several maps no map, but a frame. It may be on either side.
TEST_F(ImagePairs, AnImageOfSeveralMapsHasAFrame) {
    add("a", {"p_height.3.png"});
    add("b", {"p_height.3.png"});
    BakedSet set = small_set("p", {3}, {3});
    set.maps.push_back({"film", "mask", "0 to 1", "", {3}, {}});
    set.files.front().maps = {"height", "film"};
    add_manifest("a", set);
    for (const auto& [left, right] : {std::pair("a", "b"), std::pair("b", "a")}) {
        const std::vector<ImagePair> found = image_pairs(path(left), path(right), {});
        ASSERT_EQ(found.size(), 1U);
        EXPECT_EQ(found[0].map, "");
        EXPECT_EQ(found[0].frame, 3);
    }
}

TEST_F(ImagePairs, VectorFilesOfManifestsAreLeftOut) {
    BakedSet set = small_set("p", {1, 2}, {1, 2});
    set.files.back().path = "drawing.svg";
    add_manifest("a", set);
    EXPECT_EQ(pairs("a/manifest.json", "a/manifest.json"), Texts{"= a/p_height.1.png"});
}

// The folder of the second manifest has a file that this manifest does not list.
TEST_F(ImagePairs, ManifestsPairTheFilesThatTheyList) {
    add_manifest("a", small_set("p", {1, 2}, {1, 2}));
    add_manifest("b", small_set("p", {2, 3}, {2, 3}));
    add("b", {"p_height.1.png"});
    EXPECT_EQ(pairs("a/manifest.json", "b/manifest.json"),
              (Texts{"- a/p_height.1.png", "= b/p_height.2.png", "+ b/p_height.3.png"}));
}

TEST_F(ImagePairs, AManifestCannotNameFilesOutsideOfItsFolder) {
    BakedSet set = small_set("p", {1}, {1});
    add_manifest("a", set);
    set.files.front().path = "../secret.png";
    add_manifest("b", set);
    EXPECT_THROW(pairs("a/manifest.json", "b/manifest.json"), InputError);
    add("a", {"p_height.1.png"});
    EXPECT_THROW(pairs("a", "b"), InputError);
}

TEST_F(ImagePairs, BothSidesAreOfTheSameKind) {
    add("folder", {"x.png"});
    add("", {"x.png", "manifest.json"});
    EXPECT_THROW(pairs("folder", "none"), InputError);
    EXPECT_THROW(pairs("none.json", "folder"), InputError);
    for (const char* other : {"x.png", "x.####.png", "manifest.json"}) {
        EXPECT_THROW(pairs("folder", other), std::invalid_argument) << other;
        EXPECT_THROW(pairs(other, "folder"), std::invalid_argument) << other;
    }
    EXPECT_THROW(pairs("{map}.####.png", "{map}.####.png"), std::invalid_argument);
}

// A comparison of nothing must not pass a test.
TEST_F(ImagePairs, NoImagesAreAnError) {
    make_folders(folder_.path() / "a");
    EXPECT_THROW(pairs("a", "a"), InputError);
    EXPECT_THROW(pairs("x.####.png", "y.####.png"), InputError);
    EXPECT_THROW(pairs("none.json", "none.json"), InputError);
}

}  // namespace
}  // namespace foam::texgen
