// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_files.h"

#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

namespace fs = std::filesystem;

class PresetFiles : public testing::Test {
  protected:
    void write(const std::string& name, const std::string& toml) {
        fs::create_directories((folder_.path() / name).parent_path());
        std::ofstream(folder_.path() / name) << toml;
    }

    // Returns the files of a preset in the folder. Their paths are relative to it.
    std::vector<std::string> files(const std::string& name) {
        std::vector<std::string> names;
        for (const fs::path& file : preset_files((folder_.path() / name).string())) {
            names.push_back(file.lexically_relative(folder_.path()).string());
        }
        return names;
    }

    TemporaryFolder folder_;
};

using Names = std::vector<std::string>;

TEST_F(PresetFiles, AreThePresetAndThoseThatItExtends) {
    write("a.toml", "extends = \"base/b.toml\"\n[foam]\nbubbles = 40\n");
    write("base/b.toml", "extends = \"../c.toml\"\n");
    write("c.toml", "extends = \"sea_foam\"\n");
    EXPECT_EQ(files("a.toml"), (Names{"a.toml", "base/b.toml", "c.toml"}));
}

TEST_F(PresetFiles, IncludePicturesRelativeToTheirPreset) {
    write("a.toml",
          "extends = \"base/b.toml\"\n[foam]\ndensity = \"cat.png\"\noutline = "
          "\"shapes/star.svg\"\n[albedo]\ncolors = { from = \"photo.exr\" }\n[output]\npattern = "
          "\"out/{map}.png\"\n");
    write("base/b.toml", "[albedo]\npicture = \"dog.png\"\n");
    EXPECT_EQ(
        files("a.toml"),
        (Names{
            "a.toml", "base/b.toml", "base/dog.png", "cat.png", "shapes/star.svg", "photo.exr"}));
}

// The values of foam.density that are no files.
TEST_F(PresetFiles, DoNotIncludeOtherValues) {
    write("a.toml", "[foam]\ndensity = \"radial\"\n");
    EXPECT_EQ(files("a.toml"), Names{"a.toml"});
}

TEST_F(PresetFiles, IncludeAPresetThatCannotBeRead) {
    write("broken.toml", "extends = \n");
    EXPECT_EQ(files("broken.toml"), Names{"broken.toml"});
    EXPECT_EQ(files("missing.toml"), Names{"missing.toml"});
    write("circle.toml", "extends = \"circle.toml\"\n");
    EXPECT_EQ(files("circle.toml"), Names{"circle.toml"});
}

TEST(PresetFilesOfNames, AreThoseOfTheAssignments) {
    EXPECT_TRUE(preset_files("sea_foam").empty());
    const std::array<Assignment, 2> more = {read_set_argument("foam.density=cat.png"),
                                            read_set_argument("output.pattern=x.png")};
    EXPECT_EQ(preset_files("sea_foam", more), (std::vector<fs::path>{"cat.png"}));
}

}  // namespace
}  // namespace foam::texgen
