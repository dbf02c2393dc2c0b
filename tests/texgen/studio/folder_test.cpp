// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/folder.h"

#include "core/files/file_io.h"
#include "core/files/scratch_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace foam::texgen {
namespace {

namespace fs = std::filesystem;

TEST(StudioFolder, GivesPathsBelowIt) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    EXPECT_EQ(folder.below("out/frame.png"), folder.path() / "out/frame.png");
    EXPECT_EQ(folder.below("."), folder.path());
    EXPECT_EQ(folder.below(""), folder.path());
}

TEST(StudioFolder, RejectsPathsThatLeaveIt) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    for (const char* path : {"..", "../x", "out/../../x", "out/..", "/etc/passwd", "/", "a\nb"}) {
        EXPECT_THROW(folder.below(path), PathRejected) << path;
    }
}

TEST(StudioFolder, MessagesAreOneLine) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    try {
        folder.below("a\nb.toml");
        FAIL() << "not rejected";
    } catch (const PathRejected& error) {
        EXPECT_STREQ(error.what(), "'a b.toml': must not contain control characters");
    }
}

TEST(StudioFolder, RejectsLinksThatLeaveIt) {
    const ScratchFolder scratch;
    const ScratchFolder outside;
    fs::create_directory_symlink(outside.path(), scratch.path() / "link");
    fs::create_directory(scratch.path() / "inside");
    fs::create_directory_symlink("inside", scratch.path() / "local");
    const StudioFolder folder(scratch.path());
    EXPECT_THROW(folder.below("link"), PathRejected);
    EXPECT_THROW(folder.below("link/x.png"), PathRejected);
    EXPECT_EQ(folder.below("local/x.png"), folder.path() / "inside/x.png");
}

TEST(StudioFolder, AFolderWithTheSameBeginningIsOutside) {
    const ScratchFolder scratch;
    fs::create_directories(scratch.path() / "a");
    fs::create_directories(scratch.path() / "ab");
    fs::create_directory_symlink("../ab", scratch.path() / "a/link");
    const StudioFolder folder(scratch.path() / "a");
    EXPECT_THROW(folder.below("link"), PathRejected);
}

TEST(StudioFolder, IsMadeIfItDoesNotExist) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path() / "a" / "b");
    EXPECT_TRUE(fs::is_directory(folder.path()));
    std::ofstream(scratch.path() / "file") << "x";
    EXPECT_THROW(StudioFolder(scratch.path() / "file"), OutputError);
    EXPECT_THROW(StudioFolder(scratch.path() / "file" / "below"), OutputError);
}

TEST(StudioFolder, ListsPresetsAndBakes) {
    const ScratchFolder scratch;
    for (const char* name : {"b.toml", "a.toml", ".hidden.toml", "a.txt"}) {
        std::ofstream(scratch.path() / name) << "";
    }
    fs::create_directories(scratch.path() / "out/deep/er/too_deep");
    for (const char* name : {"manifest.json",
                             "out/manifest.json",
                             "out/deep/er/manifest.json",
                             "out/deep/er/too_deep/manifest.json"}) {
        std::ofstream(scratch.path() / name) << "{}";
    }
    const StudioFolder folder(scratch.path());
    EXPECT_EQ(folder.preset_files(), (std::vector<std::string>{"a.toml", "b.toml"}));
    EXPECT_EQ(
        folder.bakes(),
        (std::vector<fs::path>{"manifest.json", "out/deep/er/manifest.json", "out/manifest.json"}));
}

}  // namespace
}  // namespace foam::texgen
