// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/existing_sequence.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

class ExistingSequence : public testing::Test {
  protected:
    /// Creates empty files in the folder and returns the frames of a pattern in it.
    std::vector<int> frames(const std::vector<std::string>& files, const std::string& pattern) {
        for (const std::string& file : files) {
            const std::filesystem::path path = folder_.path() / file;
            make_folders(path.parent_path());
            write_file(path, {});
        }
        std::vector<int> numbers;
        for (const auto& [frame, path] :
             existing_sequence(FilePattern((folder_.path() / pattern).string()))) {
            EXPECT_TRUE(std::filesystem::is_regular_file(path)) << path;
            numbers.push_back(frame);
        }
        return numbers;
    }

    TemporaryFolder folder_;
};

using Frames = std::vector<int>;

TEST_F(ExistingSequence, ContainsTheFilesOfThePattern) {
    EXPECT_EQ(frames({"a.0003.png",
                      "a.0001.png",
                      "a.12345.png",
                      "a.0000.png",
                      "a.004.png",     // too few digits
                      "a.01234.png",   // a zero too many
                      "b.0005.png",    // another name
                      "a.0006.exr",    // another format
                      "a.0007.png.x",  // another end
                      "c/a.0008.png"},
                     "a.####.png"),
              (Frames{0, 1, 3, 12345}));
}

TEST_F(ExistingSequence, OtherNumbersMayBeInTheName) {
    EXPECT_EQ(frames({"v2_a1.0001.png", "v3_a1.0002.png", "v2_a1.0007.png"}, "v2_a1.####.png"),
              (Frames{1, 7}));
    EXPECT_EQ(frames({"x42.png", "x432.png"}, "x@2.png"), (Frames{4, 43}));
}

TEST_F(ExistingSequence, AFolderMayHaveTheFrameNumber) {
    EXPECT_EQ(frames({"f1/a.0001.png", "f2/a.0002.png", "f2/a.0003.png"}, "f%d/a.####.png"),
              (Frames{1, 2}));
}

TEST_F(ExistingSequence, IsEmptyWithoutFiles) {
    EXPECT_EQ(frames({}, "a.####.png"), Frames{});
    EXPECT_EQ(frames({}, "none/a.####.png"), Frames{});
    make_folders(folder_.path() / "a.0001.png");
    EXPECT_EQ(frames({}, "a.####.png"), Frames{});
}

}  // namespace
}  // namespace foam::texgen
