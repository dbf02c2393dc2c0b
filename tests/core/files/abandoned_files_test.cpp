// SPDX-License-Identifier: Apache-2.0

#include "core/files/abandoned_files.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace foam {
namespace {

constexpr std::chrono::hours kOld{25};

std::filesystem::path file_of_age(const TemporaryFolder& folder,
                                  const std::string& name,
                                  std::chrono::hours age) {
    std::filesystem::path path = folder.path() / name;
    std::ofstream(path) << "some content";
    std::filesystem::last_write_time(path, std::filesystem::file_time_type::clock::now() - age);
    return path;
}

TEST(RemoveAbandonedFiles, RemovesOldTemporaryFilesOnly) {
    const TemporaryFolder folder;
    const auto old = file_of_age(folder, "lit.0001.png.foamtex-4711-12.part", kOld);
    std::vector<std::filesystem::path> kept{
        file_of_age(folder, "lit.0002.png.foamtex-4711-13.part", std::chrono::hours(23)),
        folder.path() / "folder.foamtex-1-1.part"};
    std::filesystem::create_directory(kept.back());
    for (const char* const name : {"archive.part",
                                   "archive.zip.12.part",
                                   "backup.2024-11.part",
                                   "pkg_1.2-3.part",
                                   "ubuntu-22.04-1.part",
                                   "lit.0001.png",
                                   ".foamtex-1-1.part",
                                   "a.foamtex-1-.part",
                                   "a.foamtex-1-1.part.png"}) {
        kept.push_back(file_of_age(folder, name, kOld));
    }
    kept.push_back(folder.path() / "link.foamtex-1-1.part");
    std::filesystem::create_symlink("lit.0001.png", kept.back());
    remove_abandoned_files(folder.path());
    EXPECT_FALSE(std::filesystem::exists(old));
    for (const std::filesystem::path& path : kept) {
        EXPECT_TRUE(std::filesystem::exists(path)) << path;
    }
}

TEST(RemoveAbandonedFiles, IgnoresAFolderThatDoesNotExist) {
    const TemporaryFolder folder;
    EXPECT_NO_THROW(remove_abandoned_files(folder.path() / "missing"));
}

}  // namespace
}  // namespace foam
