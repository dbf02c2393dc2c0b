// SPDX-License-Identifier: Apache-2.0

#include "texgen/material/profile.h"

#include "tests/support/temporary_folder.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

using Names = std::vector<std::string>;

std::string written(const TemporaryFolder& folder, std::string_view toml) {
    const std::filesystem::path path = folder.path() / "mine.toml";
    std::ofstream(path) << toml;
    return path.string();
}

// Returns the message of the error that loading a profile with this text throws.
std::string fault_of(std::string_view toml) {
    const TemporaryFolder folder;
    try {
        load_profile(written(folder, toml));
        return "no error";
    } catch (const PresetError& error) {
        const std::string message = error.what();
        return message.substr(message.find("mine.toml"));
    }
}

TEST(Profile, IsReadFromAFile) {
    const TemporaryFolder folder;
    const Profile profile = load_profile(written(
        folder,
        "[profile]\ndescription = \"Ours\"\n[image]\nmaps = [\"albedo\"]\n[normal]\ny = \"dx\"\n"));
    EXPECT_EQ(profile.name, "mine");
    EXPECT_EQ(profile.description, "Ours");
    Preset preset;
    assign(preset, assignments_for(profile, preset));
    EXPECT_EQ(preset.image.maps, Names{"albedo"});
    EXPECT_EQ(preset.maps.normal.y, NormalY::Down);
}

TEST(Profile, CannotChangeTheFoam) {
    for (const char* table : {"foam", "dynamics", "frames", "loop"}) {
        EXPECT_NE(fault_of("[" + std::string(table) + "]\n")
                      .find("a profile can only set keys of the maps and of the tables preset, "
                            "image, camera, output, vector and mesh"),
                  std::string::npos)
            << table;
    }
    for (const char* table : {"preset", "image", "camera", "output", "vector", "mesh", "albedo"}) {
        EXPECT_EQ(fault_of("[" + std::string(table) + "]\n"), "no error") << table;
    }
    EXPECT_NE(fault_of("[[event]]\nkind = \"collapse\"\n").find("a profile can only set"),
              std::string::npos);
}

TEST(Profile, RejectsOtherKeysOfItsOwnTable) {
    EXPECT_NE(fault_of("[profile]\nname = \"x\"\n").find("mine.toml:2: key 'profile.name'"),
              std::string::npos);
    EXPECT_NE(fault_of("[profile]\ndescription = 3\n").find("must be a text in quotes"),
              std::string::npos);
    EXPECT_NE(fault_of("[profile\n").find("mine.toml:1"), std::string::npos);
    EXPECT_THROW(load_profile("missing/file.toml"), PresetError);
}

TEST(Profile, TakesTheColorsOfThePreset) {
    Preset preset;
    preset.image.maps = {"height", "lit"};
    EXPECT_EQ(base_color_map(preset), "albedo");
    preset.maps.lit.colors = LitColors::ThinFilm;
    EXPECT_EQ(base_color_map(preset), "thin_film");
    preset.maps.lit.colors = LitColors::Maze;
    EXPECT_EQ(base_color_map(preset), "maze");
    preset.image.maps = {"emission", "id_color", "caustics"};
    EXPECT_EQ(base_color_map(preset), "caustics");
    preset.image.maps = {"pressure"};
    EXPECT_EQ(base_color_map(preset), "albedo");
}

// Returns a preset whose map of colors is thin_film, with a profile assigned to it. `toml` is the
// text of the profile.
Preset thin_film_with(const std::string& toml) {
    const TemporaryFolder folder;
    Preset preset;
    preset.image.maps = {"thin_film"};
    assign(preset, assignments_for(load_profile(written(folder, toml)), preset));
    return preset;
}

// The word albedo is replaced where it is the name of the map, also within packings and names.
TEST(Profile, ReplacesTheMapAlbedo) {
    const Preset preset = thin_film_with(
        "[image]\nmaps = [\"albedo\", \"normal\"]\n[output]\n"
        "pack = [\"my_albedo=albedo.R,albedo.G,albedo.B,roughness\"]\n"
        "names = [\"albedo=BC\"]\n");
    EXPECT_EQ(preset.image.maps, (Names{"thin_film", "normal"}));
    EXPECT_EQ(preset.output.pack, Names{"my_albedo=thin_film.R,thin_film.G,thin_film.B,roughness"});
    EXPECT_EQ(preset.output.names, Names{"thin_film=BC"});
}

TEST(Profile, KeepsTheMapAlbedoIfItAlsoListsTheMapWithTheColors) {
    const Preset preset = thin_film_with(
        "[image]\nmaps = [\"thin_film\", \"albedo\"]\n[output]\n"
        "names = [\"thin_film=Film\", \"albedo=BC\"]\n");
    EXPECT_EQ(preset.image.maps, (Names{"thin_film", "albedo"}));
    EXPECT_EQ(preset.output.names, (Names{"thin_film=Film", "albedo=BC"}));
}

TEST(Profile, ReplacesTheMapAlbedoIfItListsOnlyTheMapWithTheColors) {
    const Preset preset =
        thin_film_with("[image]\nmaps = [\"thin_film\"]\n[output]\nnames = [\"albedo=BC\"]\n");
    EXPECT_EQ(preset.output.names, Names{"thin_film=BC"});
}

TEST(Profile, DoesNotReplaceNamesOfPackingsAndWordsOfFileNames) {
    const Preset preset = thin_film_with(
        "[output]\npack = [\"albedo-mask=albedo.R,albedo.G,albedo.B\"]\n"
        "names = [\"albedo=albedo\", \"roughness=albedo-rough\"]\n");
    EXPECT_EQ(preset.output.pack, Names{"albedo-mask=thin_film.R,thin_film.G,thin_film.B"});
    EXPECT_EQ(preset.output.names, (Names{"thin_film=albedo", "roughness=albedo-rough"}));
}

TEST(Profile, LeavesOutTheEmissionOfAPresetThatDoesNotGlow) {
    const Profile profile = load_profile("gltf");
    Preset preset;
    assign(preset, assignments_for(profile, preset));
    EXPECT_EQ(preset.image.maps, (Names{"albedo", "normal"}));
    preset.maps.lit.glow = 0.5;
    assign(preset, assignments_for(profile, preset));
    EXPECT_EQ(preset.image.maps, (Names{"albedo", "normal", "emission"}));
}

}  // namespace
}  // namespace foam::texgen
