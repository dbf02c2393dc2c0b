// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/manifest_file.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/manifest/small_set.h"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <thread>
#include <vector>

namespace foam::texgen {
namespace {

TEST(ManifestFile, IsTheOnlyFileWrittenAndIsReadBack) {
    const TemporaryFolder folder;
    const std::filesystem::path deep = folder.path() / "a" / "b";
    update_manifest(deep, [](Manifest& manifest) { merge(manifest, small_set("a", {1}, {1})); });
    update_manifest(deep, [](Manifest& manifest) { merge(manifest, small_set("b", {1}, {1})); });
    EXPECT_EQ(folder.files(), std::vector<std::string>{"a/b/manifest.json"});
    EXPECT_EQ(read_manifest(deep).sets.size(), 2U);
    EXPECT_EQ(read_manifest(deep), read_manifest(deep / kManifestName));
    EXPECT_THROW(read_manifest(folder.path()), InputError);
}

void add_frame(const std::filesystem::path& folder, int frame) {
    update_manifest(folder,
                    [&](Manifest& manifest) { merge(manifest, small_set("a", {frame}, {frame})); });
}

// The folder of the pattern "{map}.png" is empty (FilePattern::folder).
TEST(ManifestFile, OfAnEmptyPathIsInTheWorkingFolder) {
    EXPECT_EQ(manifest_path(""), kManifestName);
    const TemporaryFolder folder;
    EXPECT_EQ(manifest_path(folder.path()), folder.path() / kManifestName);
    EXPECT_EQ(manifest_path("a/other.json"), "a/other.json");
}

// Four threads change the manifest at the same time. No change gets lost.
TEST(ManifestFile, OneChangeGoesOnAtATime) {
    const TemporaryFolder folder;
    const auto add_frames = [&](int first) {
        for (int frame = first; frame < first + 10; ++frame) {
            add_frame(folder.path(), frame);
        }
    };
    {
        const std::jthread one(add_frames, 1);
        const std::jthread two(add_frames, 11);
        const std::jthread three(add_frames, 21);
        add_frames(31);
    }
    const Manifest manifest = read_manifest(folder.path());
    ASSERT_EQ(manifest.sets.size(), 1U);
    EXPECT_EQ(manifest.sets.front().files.size(), 40U);
    EXPECT_EQ(folder.files(), std::vector<std::string>{"manifest.json"});
}

TEST(ManifestFile, DoesNotOverwriteFilesOfOtherPrograms) {
    const TemporaryFolder folder;
    const std::string other = R"({"name": "a web app"})";
    write_file(folder.path() / "manifest.json", std::as_bytes(std::span(other)));
    EXPECT_THROW(manifest_in(folder.path()), InputError);
    EXPECT_THROW(add_frame(folder.path(), 1), InputError);
    EXPECT_EQ(read_file(folder.path() / "manifest.json", kImageInput).size(), other.size());
    EXPECT_EQ(folder.files().size(), 1U);
    EXPECT_EQ(manifest_in(folder.path() / "none"), Manifest{});
}

}  // namespace
}  // namespace foam::texgen
