// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/drawn_images.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Preset packed_preset() {
    Preset preset;
    preset.image.maps = {"albedo", "roughness"};
    preset.output.pack = {"ORM=occlusion,roughness,0", "H=height,height,height"};
    return preset;
}

TEST(DrawnImages, AreTheMapsAndThenThePackings) {
    std::vector<std::string> names;
    for (const DrawnImage& image : drawn_images(packed_preset())) {
        names.emplace_back(image.name());
    }
    EXPECT_EQ(names, (std::vector<std::string>{"albedo", "roughness", "ORM", "H"}));
}

TEST(DrawnImages, NeedEachMapOnce) {
    EXPECT_EQ(source_map_names(packed_preset()),
              (std::vector<std::string>{"albedo", "roughness", "occlusion", "height"}));
}

TEST(DrawnImages, HaveTheirNamesOrGivenWordsInFileNames) {
    Preset preset = packed_preset();
    preset.output.names = {"albedo=BC"};
    EXPECT_EQ(file_word(preset, "albedo"), "BC");
    EXPECT_EQ(file_word(preset, "roughness"), "roughness");
    EXPECT_EQ(file_word(preset, "ORM"), "ORM");
}

TEST(DrawnImages, MustHaveDifferentWords) {
    Preset preset = packed_preset();
    EXPECT_NO_THROW(check_file_words(preset));
    preset.output.names = {"albedo=ORM"};
    EXPECT_THROW(check_file_words(preset), std::invalid_argument);
    preset.output.names = {};
    preset.output.pack = {"ORM=occlusion,roughness,0", "ORM=0,0,0"};
    EXPECT_THROW(check_file_words(preset), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
