// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/placeholder.h"

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Preset preset_of(const std::vector<std::string>& sets) {
    Preset preset;
    preset.name = "lava";
    std::vector<Assignment> assignments;
    for (const std::string& set : sets) {
        assignments.push_back(read_set_argument(set));
    }
    assign(preset, assignments);
    return preset;
}

std::string failure(const std::string& name, const Preset& preset = preset_of({})) {
    try {
        return "no failure: " + placeholder_text(preset, name);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
}

TEST(PlaceholderText, NamesPresetSeedAndSize) {
    const Preset preset = preset_of({"foam.seed=42", "image.size=[2048, 1024]"});
    EXPECT_EQ(placeholder_text(preset, "preset"), "lava");
    EXPECT_EQ(placeholder_text(preset, "seed"), "42");
    EXPECT_EQ(placeholder_text(preset, "size"), "2048x1024");
    EXPECT_EQ(placeholder_text(preset_of({"image.size=[512, 512]"}), "size"), "512");
}

TEST(PlaceholderText, NumbersAreShort) {
    const Preset preset = preset_of(
        {"foam.bubbles=200", "camera.zoom=2.0", "dynamics.kappa=0.1", "foam.domain=patch"});
    EXPECT_EQ(placeholder_text(preset, "foam.bubbles"), "200");
    EXPECT_EQ(placeholder_text(preset, "camera.zoom"), "2");
    EXPECT_EQ(placeholder_text(preset, "dynamics.kappa"), "0.1");
    EXPECT_EQ(placeholder_text(preset, "foam.domain"), "patch");
}

TEST(PlaceholderText, AnUnknownNameSuggestsAnother) {
    EXPECT_EQ(failure("sede"), "unknown placeholder '{sede}'; did you mean {seed}?");
    EXPECT_EQ(failure("maps"), "unknown placeholder '{maps}'; did you mean {map}?");
    EXPECT_EQ(failure("bubbles"), "unknown placeholder '{bubbles}'; did you mean {foam.bubbles}?");
    EXPECT_EQ(failure("loop.amplitud"),
              "unknown placeholder '{loop.amplitud}'; did you mean {loop.amplitude}?");
    EXPECT_EQ(failure("whatever it is"),
              "unknown placeholder '{whatever it is}'; must be {preset}, {map}, {seed}, {size} or "
              "a key such as {foam.bubbles}");
}

TEST(PlaceholderText, AValueThatIsNoFileNameIsAnError) {
    EXPECT_EQ(failure("image.size"),
              "placeholder {image.size}: the value is a list; did you mean {size}?");
    EXPECT_EQ(failure("image.maps"),
              "placeholder {image.maps}: the value is a list, which is no part of a file name");
    EXPECT_EQ(failure("height.full", preset_of({"height.full=auto"})),
              "placeholder {height.full}: the value is \"auto\", a number that only the bake "
              "finds; set a number");
    EXPECT_EQ(failure("output.pattern"),
              "placeholder {output.pattern}: a file name cannot contain a pattern of file names");
    EXPECT_EQ(failure("preset.description", preset_of({"preset.description=#?"})),
              "placeholder {preset.description}: the value '#?' has no letter and no digit");
    EXPECT_EQ(
        failure("preset.description", preset_of({"preset.description=" + std::string(65, 'x')})),
        "placeholder {preset.description}: the value has 65 bytes; a file name may contain a text "
        "of at most 64");
    EXPECT_EQ(placeholder_text(preset_of({"preset.description=" + std::string(64, 'x')}),
                               "preset.description"),
              std::string(64, 'x'));
}

// A word of a key is no number, even if the word is "auto".
TEST(PlaceholderText, TheWordAutoOfAKeyIsAValue) {
    EXPECT_EQ(placeholder_text(preset_of({}), "output.block_compression"), "auto");
}

// No value may leave the folder of the images, hide a file, or look like a placeholder.
TEST(PlaceholderText, EveryKeyIsAPartOfAFileNameOrAnError) {
    const Preset preset = preset_of({});
    for (const Key<Preset>& key : preset_keys()) {
        try {
            const std::string text = placeholder_text(preset, key.path);
            EXPECT_EQ(text.find_first_of("/\\{}#@%:*?\"<>|~$ "), std::string::npos) << key.path;
            EXPECT_FALSE(text.empty() || text.front() == '.') << key.path;
        } catch (const std::invalid_argument&) {
        }
    }
}

TEST(FileNamePart, KeepsOnlySafeCharacters) {
    EXPECT_EQ(file_name_part("#ff8800"), "ff8800");
    EXPECT_EQ(file_name_part("sea foam, at dawn"), "sea-foam-at-dawn");
    EXPECT_EQ(file_name_part("../../etc/passwd"), "etc-passwd");
    EXPECT_EQ(file_name_part("pictures/cat.png"), "pictures-cat.png");
    EXPECT_EQ(file_name_part("a_b-c"), "a_b-c");
    EXPECT_EQ(file_name_part("caf\u00e9"), "caf\u00e9");
    EXPECT_EQ(file_name_part(".."), "");
    EXPECT_EQ(file_name_part(""), "");
}

TEST(WithPlaceholdersFilled, KeepsTheMap) {
    const Preset preset = preset_of({"foam.seed=3"});
    EXPECT_EQ(with_placeholders_filled(preset, "out/{preset}_{seed}_{map}"), "out/lava_3_{map}");
    EXPECT_EQ(with_placeholders_filled(preset, "plain"), "plain");
    EXPECT_EQ(with_placeholders_filled(preset, ""), "");
    EXPECT_THROW(with_placeholders_filled(preset, "{map"), std::invalid_argument);
    EXPECT_THROW(with_placeholders_filled(preset, "{sead}{map}"), std::invalid_argument);
}

}  // namespace
}  // namespace foam::texgen
