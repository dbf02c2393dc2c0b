// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_schema.h"

#include "tests/support/places.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/image/external_program.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kConforms = 0;
constexpr int kDoesNotConform = 1;

// Validates texts of presets by a program that is not ours. Returns its exit code; -1 if there is
// no Python.
int validate(const std::vector<std::string>& presets) {
    const TemporaryFolder folder;
    const auto write = [&](const std::string& name, const std::string& text) {
        const std::filesystem::path path = folder.path() / name;
        std::ofstream(path) << text;
        return path.string();
    };
    std::vector<std::string> command{
        "python3",
        (foam::test::data_folder() / "../texgen/preset/validate_presets.py").string(),
        write("schema.json", preset_schema())};
    for (std::size_t k = 0; k < presets.size(); ++k) {
        command.push_back(write(std::to_string(k) + ".toml", presets[k]));
    }
    return run_external(command, {.folder = {}, .shows_errors = false}).value_or(-1);
}

TEST(PresetSchema, EveryShippedPresetConforms) {
    std::vector<std::string> texts;
    for (const ShippedPreset& shipped : shipped_presets()) {
        texts.emplace_back(shipped.toml);
        texts.push_back(to_toml(load_preset(std::string(shipped.name))));  // with every key
    }
    EXPECT_EQ(validate(texts), kConforms);
}

// What the schema rejects, the program rejects, too.
TEST(PresetSchema, RejectsWhatTheProgramRejects) {
    for (const char* bad : {"[foam]\nbubles = 10",
                            "[foam]\nbubbles = 3",
                            "[foam]\nbubbles = \"many\"",
                            "[foam]\ndomain = \"sphere\"",
                            "[foam]\narea_ratio = 0.5",
                            "[foam]\noutline = \"star\"",
                            "[image]\nsize = [64]",
                            "[image]\nmaps = [\"albedo\", \"albedo\"]",
                            "[image]\nmaps = []",
                            "[albedo]\nfilm_color = \"white\"",
                            "[[event]]\nkind = \"explode\"\nframe = 2",
                            "[[event]]\nkind = \"shear\"\nframe = 2\nstrain = \"much\"",
                            "[[event]]\nkind = \"shear\"\nframe = 2\narea = 1.0",
                            "[[event]]\nframe = 2",
                            "[fog]\ndensity = 1"}) {
        EXPECT_EQ(validate({bad}), kDoesNotConform) << bad;
        EXPECT_THROW(parse_preset(bad, "bad", "bad.toml"), PresetError) << bad;
    }
}

// Forms that a key takes beside its usual one.
TEST(PresetSchema, AcceptsEveryFormOfAValue) {
    for (const char* good : {"extends = \"sea_foam\"",
                             "[foam]\narea_ratio = 0",
                             "[foam]\narea_ratio = 20",
                             "[image]\nmaps = \"height\"",
                             "[foam]\ndomain = \"patch\"\noutline = \"POLYGON((0 0, 1 0, 1 1))\"",
                             "[[event]]\nkind = \"shear\"\ntime = 3\nstrain = 0.5",
                             "[[event]]\nkind = \"collapse\"\nframes = [2, 9]\nbubble = [1, 2]"}) {
        EXPECT_EQ(validate({good}), kConforms) << good;
    }
}

}  // namespace
}  // namespace foam::texgen
