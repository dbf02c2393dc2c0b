// SPDX-License-Identifier: Apache-2.0

#include "core/files/scratch_folder.h"

#include "core/files/file_io.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace foam::texgen {
namespace {

TEST(ScratchFolder, IsEmptyAndRemovedAfterwards) {
    std::filesystem::path path;
    {
        const ScratchFolder folder;
        const ScratchFolder other;
        path = folder.path();
        EXPECT_TRUE(std::filesystem::is_empty(path));
        EXPECT_NE(path, other.path());
        write_file(path / "a", {});
    }
    EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace foam::texgen
