// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/load_preset.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/preset/rejection.h"
#include "texgen/image/png.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

std::string failure(const std::string& name_or_path) {
    return test::rejection_of([&] { load_preset(name_or_path); });
}

void write_text(const std::filesystem::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text)));
}

TEST(ShippedPresets, AllLoadByNameAndHaveADescription) {
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        EXPECT_EQ(preset.name, shipped.name);
        EXPECT_FALSE(preset.description.empty()) << shipped.name;
    }
}

TEST(ShippedPresets, AnUnknownNameSuggestsTheNearest) {
    EXPECT_EQ(failure("sea_form"),
              "preset 'sea_form': must be a .toml file or a name; did you mean 'sea_foam'?");
    EXPECT_EQ(failure("lava.tml"),
              "preset 'lava.tml': must be a .toml file or a name; did you mean 'lava'?");
    EXPECT_EQ(failure("sea.foam"),
              "preset 'sea.foam': must be a .toml file or a name; did you mean 'sea_foam'?");
    EXPECT_EQ(
        failure("marzipan"),
        "preset 'marzipan': must be a .toml file or a name; 'foamtex presets' lists all presets");
}

TEST(LoadPreset, APathIsAFileAndItsStemTheName) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_text(path, "[foam]\nbubbles = 77\n");
    const Preset preset = load_preset(path.string());
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.seeding.bubbles, 77);
}

TEST(LoadPreset, AnExtensionChangesOnlyItsKeys) {
    const TemporaryFolder folder;
    write_text(folder.path() / "base.toml",
               "[foam]\nbubbles = 50\nseed = 4\n[[event]]\nkind = 'collapse'\nsides = 5\n"
               "frame = 3\n");
    const auto path = folder.path() / "mine.toml";
    write_text(path, "extends = 'base.toml'\n[foam]\nseed = 9\n");
    const Preset preset = load_preset(path.string());
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.seeding.bubbles, 50);
    EXPECT_EQ(preset.seeding.seed, 9U);
    EXPECT_EQ(preset.events.size(), 1U);
}

TEST(LoadPreset, AssignmentsAreThoseOfItsOwnDocument) {
    const TemporaryFolder folder;
    write_text(folder.path() / "base.toml", "[foam]\nbubbles = 50\n");
    const auto path = folder.path() / "mine.toml";
    write_text(path, "extends = 'base.toml'\n[foam]\nseed = 9\n");
    const LoadedPreset loaded = load_with_assignments(path.string());
    EXPECT_EQ(loaded.preset.seeding.bubbles, 50);
    // The first assignment is that of the table itself.
    ASSERT_EQ(loaded.assignments.size(), 2U);
    EXPECT_EQ(loaded.assignments.front().key, "foam");
    EXPECT_EQ(loaded.assignments.back().key, "foam.seed");
}

TEST(LoadPreset, EventsOfAnExtensionReplaceThoseOfTheBase) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_text(path, "extends = 'collapse'\n[[event]]\nkind = 'collapse'\nsides = 5\nframe = 3\n");
    const Preset preset = load_preset(path.string());
    EXPECT_NE(load_preset("collapse").events.front().sides, std::vector<int>{5});
    ASSERT_EQ(preset.events.size(), 1U);
    EXPECT_EQ(preset.events.front().sides, std::vector<int>{5});
    EXPECT_EQ(preset.seeding.bubbles, load_preset("collapse").seeding.bubbles);
}

TEST(LoadPreset, ErrorOfABadExtensionNamesItsLine) {
    const TemporaryFolder folder;
    const std::string mine = (folder.path() / "mine.toml").string();
    const std::string yours = (folder.path() / "yours.toml").string();
    write_text(mine, "extends = 'yours.toml'\n");
    write_text(yours, "extends = 'mine.toml'\n");
    EXPECT_EQ(failure(mine),
              yours + ":1: key 'extends' = \"mine.toml\": circular extends: " + mine + " -> " +
                  yours + " -> " + mine);
    write_text(mine, "extends = 'none.toml'\n");
    EXPECT_EQ(failure(mine),
              mine + ":1: key 'extends' = \"none.toml\": cannot read '" +
                  (folder.path() / "none.toml").string() + "': No such file or directory");
    write_text(mine, "extends = 3\n");
    EXPECT_EQ(failure(mine),
              mine +
                  ":1: key 'extends' = 3: must be the name of a preset or a .toml file, in "
                  "quotes");
    write_text(mine, "extends = 'yours.toml'\n");
    write_text(yours, "[foam]\nbubbles = -3\n");
    EXPECT_EQ(failure(mine),
              yours + ":2: key 'foam.bubbles' = -3: must be an integer from 4 to 1000000");
}

// Messages name the document of a shipped preset presets/NAME.toml, which may also be the path of a
// file.
TEST(LoadPreset, AFileMayExtendTheShippedPresetOfItsName) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "presets");
    write_text(folder.path() / "presets/sea_foam.toml", "extends = 'sea_foam'\n");
    const std::filesystem::path before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    const std::string message = failure("presets/sea_foam.toml");
    std::filesystem::current_path(before);
    EXPECT_EQ(message, "no failure");
}

TEST(LoadPreset, AMissingOrBadFileIsNamed) {
    const TemporaryFolder folder;
    const std::string missing = (folder.path() / "none.toml").string();
    EXPECT_EQ(failure(missing), "cannot read '" + missing + "': No such file or directory");
    const auto bad = folder.path() / "bad.toml";
    write_text(bad, "[foam]\nbubbles = 1\n");
    EXPECT_EQ(failure(bad.string()).find(bad.string() + ":2: key 'foam.bubbles' = 1: "), 0U);
}

// A path of a picture is relative to the folder of the preset that names it, also if another preset
// extends this one.
TEST(LoadPreset, PicturesAreRelativeToTheFolderOfTheirPreset) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() / "a/pictures");
    const Image<std::uint8_t> gray(4, 2, 1);
    write_png(folder.path() / "a/pictures/x.png", gray.view());
    write_text(folder.path() / "a/base.toml", "[foam]\ndensity = \"pictures/x.png\"\n");
    write_text(folder.path() / "more.toml", "extends = \"a/base.toml\"\n");
    const Preset preset = load_preset((folder.path() / "more.toml").string());
    EXPECT_EQ(preset.density.source.name, (folder.path() / "a/pictures/x.png").string());
    EXPECT_EQ(preset.density.source.picture.picture->width(), 4);
    ASSERT_EQ(files_of(preset).size(), 1U);
    EXPECT_EQ(files_of(preset).front().path, preset.density.source.name);
    EXPECT_FALSE(file_hashes(preset).empty());
    EXPECT_EQ(file_hashes(Preset()), "");
}

}  // namespace
}  // namespace foam::texgen
