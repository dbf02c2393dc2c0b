// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/settings.h"

#include "core/files/scratch_folder.h"
#include "texgen/image/png.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <filesystem>
#include <fstream>

namespace foam::texgen {
namespace {

// A folder that the settings of the tests do not use.
StudioFolder any_folder() {
    return StudioFolder(".");
}

TEST(Settings, LoadAPresetWithChanges) {
    const PagePreset loaded =
        load_settings({.preset = "sea_foam", .set = {"foam.seed=7", "foam.seed=8"}}, any_folder());
    EXPECT_EQ(loaded.preset.seeding.seed, 8U);
    EXPECT_EQ(loaded.preset.name, "sea_foam");
}

TEST(Settings, AWrongValueNamesItsKey) {
    try {
        load_settings({.preset = "sea_foam", .set = {"foam.seed=7", "foam.bubbles=2"}},
                      any_folder());
        FAIL() << "not rejected";
    } catch (const SettingsRejected& error) {
        EXPECT_EQ(error.key(), "foam.bubbles");
        EXPECT_STREQ(error.what(),
                     "--set foam.bubbles=2: key 'foam.bubbles' = 2: must be an integer from 4 to "
                     "1000000");
    }
}

TEST(Settings, RejectPresetsOutsideOfTheFolder) {
    EXPECT_THROW(load_settings({.preset = "../x.toml"}, any_folder()), PathRejected);
    EXPECT_THROW(load_settings({.preset = "/etc/x.toml"}, any_folder()), PathRejected);
    EXPECT_THROW(load_settings({.preset = "no_such_preset"}, any_folder()), SettingsRejected);
}

TEST(Settings, EventsReplaceThoseOfThePreset) {
    const std::string toml = "[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 1\n";
    const PagePreset loaded =
        load_settings({.preset = "collapse", .set = {}, .events = toml}, any_folder());
    EXPECT_EQ(loaded.preset.events.size(), 1U);
    EXPECT_TRUE(load_settings({.preset = "collapse", .set = {}, .events = ""}, any_folder())
                    .preset.events.empty());
    EXPECT_THROW(load_settings({.preset = "collapse", .set = {}, .events = "[foam]\nseed = 1\n"},
                               any_folder()),
                 SettingsRejected);
}

TEST(Settings, LargeFoamsAreNotLive) {
    const PageSettings settings{.preset = "sea_foam", .set = {"foam.bubbles=20001"}};
    EXPECT_EQ(load_settings(settings, any_folder()).preset.seeding.bubbles, 20001);
    EXPECT_THROW(load_live_preset(settings, any_folder()), SettingsRejected);
}

TEST(Settings, TheCommandIsQuotedForAShell) {
    EXPECT_EQ(bake_command({.preset = "sea_foam", .set = {"foam.seed=7"}}, {"--frames", "1"}),
              "foamtex bake sea_foam --set foam.seed=7 --frames 1");
    EXPECT_EQ(
        bake_command({.preset = "my preset.toml", .set = {"albedo.colors=[\"#fff\"]", "a='b"}}),
        "foamtex bake 'my preset.toml' --set 'albedo.colors=[\"#fff\"]' --set 'a='\\''b'");
    EXPECT_FALSE(bake_command({.preset = "sea_foam", .set = {}, .events = ""}));
}

// Saves the preset file of the settings in a folder and loads it again.
Preset saved_and_loaded(const PageSettings& settings) {
    const ScratchFolder scratch;
    const StudioFolder folder(scratch.path());
    const PagePreset loaded = load_settings(settings, folder);
    std::ofstream(scratch.path() / "mine.toml") << preset_file(settings, loaded);
    return load_settings({.preset = "mine.toml"}, folder).preset;
}

TEST(Settings, APresetFileGivesTheSamePreset) {
    const std::string event = "[[event]]\nkind = \"collapse\"\nframe = 3\nbubble = 2\n";
    for (const PageSettings& settings :
         {PageSettings{.preset = "sea_foam"},
          PageSettings{.preset = "sea_foam",
          .set = {"albedo.colors=[\"#000000\", \"#ffffff\"]",
                  "foam.seed=1",
                  "foam.seed=3",
                  "image.size=[64, 32]"}},
          PageSettings{.preset = "collapse", .set = {"foam.lloyd=2"}, .events = event},
          PageSettings{.preset = "collapse", .set = {}, .events = ""}}) {
        const Preset preset = load_settings(settings, any_folder()).preset;
        EXPECT_EQ(to_toml(saved_and_loaded(settings)), to_toml(preset));
    }
}

TEST(Settings, TheDescriptionHasTheValueOfEveryKey) {
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Json described =
            describe_settings({.preset = std::string(shipped.name)}, any_folder());
        EXPECT_EQ(described["name"], shipped.name);
        EXPECT_EQ(described["values"]["image.size"], described["size"]);
        EXPECT_FALSE(described["maps"].empty());
        EXPECT_EQ(described["command"], "foamtex bake " + std::string(shipped.name));
    }
}

TEST(Settings, SimulationTellsWhetherTheFoamIsTheSame) {
    const auto simulation = [](const char* set) {
        return describe_settings({.preset = "sea_foam", .set = {set}}, any_folder())["simulation"];
    };
    EXPECT_EQ(simulation("relief.width=0.1"), simulation("relief.width=0.2"));
    EXPECT_NE(simulation("foam.seed=1"), simulation("foam.seed=2"));
}

TEST(Settings, NotesNameChangesWithoutEffect) {
    const Json described =
        describe_settings({.preset = "sea_foam",
                           .set = {"loop.drift=[1, 0]", "loop.kind=drift", "loop.amplitude=0.2"}},
                          any_folder());
    ASSERT_EQ(described["notes"].size(), 1U);
    EXPECT_NE(std::string(described["notes"][0]).find("loop.amplitude"), std::string::npos);
}

// Pictures are read only below the folder of the studio.
TEST(Settings, PicturesAreBelowTheFolder) {
    const ScratchFolder place;
    std::filesystem::create_directory(place.path() / "inside");
    const Image<std::uint8_t> pixel(1, 1, 1);
    write_png(place.path() / "inside/x.png", pixel.view());
    write_png(place.path() / "outside.png", pixel.view());
    const StudioFolder folder(place.path() / "inside");
    const PageSettings settings{.preset = "sea_foam", .set = {"foam.density=x.png"}};
    EXPECT_TRUE(load_settings(settings, folder).preset.density.source.picture.is_set());
    EXPECT_EQ(load_settings(settings, folder).assignments.front().value,
              Value{std::string("x.png")});
    EXPECT_THROW(
        load_settings({.preset = "sea_foam", .set = {"foam.density=../outside.png"}}, folder),
        PathRejected);
    EXPECT_THROW(
        load_settings({.preset = "sea_foam",
                       .set = {"albedo.picture=" + (place.path() / "outside.png").string()}},
                      folder),
        PathRejected);
}

}  // namespace
}  // namespace foam::texgen
