#include "texgen/preset/shipped_presets.h"

#include "tests/texgen/temporary_folder.h"
#include "texgen/image/file_io.h"
#include "texgen/preset/assignment.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>

namespace foam::texgen {
namespace {

std::string failure(const std::string& name_or_path) {
    try {
        load_preset(name_or_path);
    } catch (const PresetError& error) {
        return error.what();
    }
    return "no failure";
}

void write_text(const std::filesystem::path& path, std::string_view text) {
    write_file(path, std::as_bytes(std::span(text)));
}

TEST(ShippedPresets, AllLoadUnderTheirNameAndSayWhatTheyShow) {
    EXPECT_EQ(shipped_presets().size(), 7U);
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        EXPECT_EQ(preset.name, shipped.name);
        EXPECT_FALSE(preset.description.empty()) << shipped.name;
    }
}

TEST(ShippedPresets, AnUnknownNameListsTheKnownAndSuggestsTheNearest) {
    EXPECT_EQ(failure("sea_form"),
              "preset 'sea_form': must be a .toml file or one of sea_foam, labyrinth, coarsening, "
              "collapse, shear, relax, soap_raft; "
              "did you mean 'sea_foam'?");
    EXPECT_EQ(failure("beer"),
              "preset 'beer': must be a .toml file or one of sea_foam, labyrinth, coarsening, "
              "collapse, shear, relax, soap_raft");
}

TEST(ShippedPresets, APathIsAFileAndItsStemTheName) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "mine.toml";
    write_text(path, "[foam]\nbubbles = 77\n");
    const Preset preset = load_preset(path.string());
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.seeding.bubbles, 77);
}

TEST(ShippedPresets, AMissingOrBadFileIsNamed) {
    const TemporaryFolder folder;
    const std::string missing = (folder.path() / "none.toml").string();
    EXPECT_EQ(failure(missing), "cannot read '" + missing + "': No such file or directory");
    const auto bad = folder.path() / "bad.toml";
    write_text(bad, "[foam]\nbubbles = 1\n");
    EXPECT_EQ(failure(bad.string()).find(bad.string() + ":2: key 'foam.bubbles' = 1: "), 0U);
}

}  // namespace
}  // namespace foam::texgen
