// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/bake_recorder.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/manifest/manifest_file.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

constexpr const char* kPattern = "{map}.####.png";

TEST(BakeRecorder, BeginsOnce) {
    const TemporaryFolder folder;
    BakeRecorder recorder(small_preset(folder.path() / kPattern), {.frames = {1}});
    EXPECT_FALSE(recorder.begun());
    recorder.begin();
    recorder.begin();
    EXPECT_TRUE(recorder.begun());
    EXPECT_EQ(read_manifest(folder.path()).sets.size(), 1U);
}

TEST(BakeRecorder, RemovesTemporaryFilesOfAKilledProgram) {
    const TemporaryFolder folder;
    BakeRecorder recorder(small_preset(folder.path() / kPattern), {.frames = {1}});
    const std::filesystem::path abandoned = folder.path() / "albedo.0001.png.foamtex-4711-1.part";
    std::ofstream(abandoned) << "the beginning of an image";
    std::filesystem::last_write_time(
        abandoned, std::filesystem::file_time_type::clock::now() - std::chrono::hours(25));
    recorder.begin();
    EXPECT_FALSE(std::filesystem::exists(abandoned));
}

// After a failure to get the lock, a second attempt must not take as long as the first one.
TEST(BakeRecorder, WaitsForTheLockAsLongAsItIsTold) {
    const TemporaryFolder folder;
    BakeRecorder recorder(small_preset(folder.path() / kPattern), {.frames = {1}});
    recorder.begin();
    {
        const FileLock lock((folder.path() / kManifestName).string() + ".lock");
        EXPECT_THROW(recorder.close("no space", std::chrono::milliseconds(20)), OutputError);
    }
    recorder.close("no space", std::chrono::milliseconds(20));
    EXPECT_EQ(read_manifest(folder.path()).sets.front().failure, "no space");
}

}  // namespace
}  // namespace foam::texgen
