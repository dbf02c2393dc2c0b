// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_schema.h"

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "texgen/image/external_program.h"
#include "texgen/json/json_writer.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kConforms = 0;
constexpr int kDoesNotConform = 1;

// Validates texts of presets with Python's jsonschema, which shares no code with foamtex. Returns
// the exit code of the script; -1 if Python is not installed.
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

// Returns the schemas of all keys by path. Keys of events have paths such as "shear.strain"; keys
// that several kinds of events share are listed for each of them.
std::vector<std::pair<std::string, Json>> key_schemas() {
    std::vector<std::pair<std::string, Json>> keys;
    const auto add = [&keys](const std::string& table, const Json& properties) {
        for (const auto& [name, schema] : properties.items()) {
            keys.emplace_back(table + '.' + name, schema);
        }
    };
    const Json schema = Json::parse(preset_schema());
    for (const auto& [table, of_table] : schema["properties"].items()) {
        if (of_table["type"] == "object") {
            add(table, of_table["properties"]);
        }
    }
    for (const Json& kind : schema["properties"]["event"]["items"]["anyOf"]) {
        add(kind["properties"]["kind"]["enum"][0].get<std::string>(), kind["properties"]);
    }
    return keys;
}

// Returns the unit of a key; an empty text if it has none.
std::string unit_of(const std::string& path) {
    for (const auto& [key, schema] : key_schemas()) {
        if (key == path) {
            return schema.value("x-unit", "");
        }
    }
    ADD_FAILURE() << path << " is not in the schema";
    return {};
}

bool is_numeric(const Json& schema) {
    const std::string text = schema.dump();
    return text.find(R"("type":"number")") != std::string::npos ||
           text.find(R"("type":"integer")") != std::string::npos;
}

bool names_a_unit(const std::string& meaning) {
    constexpr std::array<std::string_view, 15> kWords = {"pixel",
                                                         "degrees",
                                                         "radians",
                                                         "nanometers",
                                                         "foam unit",
                                                         "foam time",
                                                         "diameters",
                                                         "in the unit",
                                                         "in cycles",
                                                         "number of ",
                                                         "frames per",
                                                         "percentage",
                                                         "as a fraction",
                                                         "in fractions",
                                                         ": fraction of"};
    return meaning.starts_with("fraction of") ||
           std::any_of(kWords.begin(), kWords.end(), [&](std::string_view word) {
               return meaning.find(word) != std::string::npos;
           });
}

TEST(PresetSchema, EveryShippedPresetConforms) {
    std::vector<std::string> texts;
    for (const ShippedPreset& shipped : shipped_presets()) {
        texts.emplace_back(shipped.toml);
        texts.push_back(to_toml(load_preset(std::string(shipped.name))));  // with all keys
    }
    EXPECT_EQ(validate(texts), kConforms);
}

// Both the schema and the program reject these presets.
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

// Some keys accept other forms of values besides the usual form.
TEST(PresetSchema, AcceptsEveryFormOfAValue) {
    for (const char* good : {"extends = \"sea_foam\"",
                             "[foam]\narea_ratio = 0",
                             "[foam]\narea_ratio = 20",
                             "[image]\nmaps = \"height\"",
                             "[foam]\ndomain = \"patch\"\noutline = \"POLYGON((0 0, 1 0, 1 1))\"",
                             "[foam]\ndomain = \"patch\"\noutline = \"  polygon((0 0, 1 0, 1 1))\"",
                             "[[event]]\nkind = \"shear\"\ntime = 3\nstrain = 0.5",
                             "[[event]]\nkind = \"collapse\"\nframes = [2, 9]\nbubble = [1, 2]"}) {
        EXPECT_EQ(validate({good}), kConforms) << good;
        if (!std::string_view(good).starts_with("extends")) {
            EXPECT_NO_THROW(parse_preset(good, "good", "good.toml")) << good;
        }
    }
}

TEST(PresetSchema, NumbersHaveUnits) {
    EXPECT_EQ(unit_of("image.size"), "pixels");
    EXPECT_EQ(unit_of("frames.count"), "frames");
    EXPECT_EQ(unit_of("frames.time_step"), "foam time");
    EXPECT_EQ(unit_of("output.frames_per_second"), "frames per second");
    EXPECT_EQ(unit_of("dynamics.t1_distance"), "foam units");
    EXPECT_EQ(unit_of("dynamics.t2_area"), "square foam units");
    EXPECT_EQ(unit_of("camera.center"), "fraction of the image width and height");
    EXPECT_EQ(unit_of("lit.azimuth"), "degrees");
    EXPECT_EQ(unit_of("thin_film.thickness"), "nanometers");
    EXPECT_EQ(unit_of("height.full"), "mean bubble diameters, selected by relief.mean_bubble");
    EXPECT_EQ(unit_of("collapse.frames"), "frames");
    EXPECT_EQ(unit_of("collapse.count"), "bubbles");
    EXPECT_EQ(unit_of("force.push"), "foam units");
    EXPECT_EQ(unit_of("drive.phase"), "cycles");
}

TEST(PresetSchema, DimensionlessNumbersHaveNoUnit) {
    for (const char* path :
         {"foam.seed", "camera.zoom", "lit.shininess", "roughness.cell", "shear.strain"}) {
        EXPECT_EQ(unit_of(path), "") << path;
    }
}

TEST(PresetSchema, EveryNumberWhoseMeaningNamesAUnitHasOne) {
    int found = 0;
    for (const auto& [path, schema] : key_schemas()) {
        if (is_numeric(schema) && names_a_unit(schema["description"].get<std::string>())) {
            EXPECT_TRUE(schema.contains("x-unit")) << path;
            ++found;
        }
    }
    EXPECT_GT(found, 0);
}

TEST(PresetSchema, OnlyNumbersHaveUnits) {
    for (const auto& [path, schema] : key_schemas()) {
        EXPECT_TRUE(is_numeric(schema) || !schema.contains("x-unit")) << path;
    }
}

TEST(PresetSchema, AUnitIsSelectedByAnExistingKey) {
    constexpr std::string_view kSelectedBy = "selected by ";
    int found = 0;
    for (const auto& [path, schema] : key_schemas()) {
        const std::string unit = schema.value("x-unit", "");
        const std::size_t at = unit.find(kSelectedBy);
        if (at != std::string::npos) {
            const Key<Preset>* key = find_key(unit.substr(at + kSelectedBy.size()));
            ASSERT_NE(key, nullptr) << path;
            EXPECT_FALSE(is_numeric(Json::parse(key->schema))) << path;
            ++found;
        }
    }
    EXPECT_GT(found, 0);
}

TEST(PresetSchema, NamesTheKeysThatAKeyDependsOn) {
    const Json tables = Json::parse(preset_schema())["properties"];
    EXPECT_EQ(tables["camera"]["properties"]["zoom"]["x-only-for"],
              Json({{"key", "foam.domain"}, {"values", {"patch"}}}));
    EXPECT_EQ(tables["albedo"]["properties"]["pressure_low"]["x-below"], "albedo.pressure_high");
}

}  // namespace
}  // namespace foam::texgen
