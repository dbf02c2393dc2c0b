// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation_files.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace foam::texgen {
namespace {

TEST(VariationFiles, HaveNumbersOfTheSameWidth) {
    const VariationFiles files("out", "lava", 12);
    EXPECT_EQ(files.sheet(), "out/lava_variations.png");
    EXPECT_EQ(files.preset(7), "out/lava_07.toml");
    EXPECT_EQ(VariationFiles("", "lava", 3).preset(3), "lava_3.toml");
}

TEST(VariationFiles, FindsThoseOfAnEarlierRun) {
    const TemporaryFolder folder;
    EXPECT_TRUE(VariationFiles(folder.path() / "none", "lava", 3).earlier().empty());
    write_variation(folder.path() / "lava_07.toml", "extends = \"lava\"\n");
    for (const char* const other : {"lava_x.toml", "lava_.toml", "lava_7.png", "sea_1.toml"}) {
        std::ofstream(folder.path() / other) << "x";
    }
    const VariationFiles files(folder.path(), "lava", 3);
    EXPECT_THAT(files.earlier(), testing::ElementsAre(folder.path() / "lava_07.toml"));
    std::ofstream(folder.path() / "lava_2.toml") << "extends = \"lava\"\n";
    EXPECT_THROW(files.earlier(), OutputError);
}

TEST(VariationFiles, AFolderWithSuchANameIsNotReplaced) {
    const TemporaryFolder folder;
    make_folders(folder.path() / "lava_1.toml");
    try {
        VariationFiles(folder.path(), "lava", 3).earlier();
        FAIL() << "nothing was thrown";
    } catch (const OutputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "'" + (folder.path() / "lava_1.toml").string() +
                      "' would be replaced or removed, but was not written by foamtex vary");
    }
}

}  // namespace
}  // namespace foam::texgen
