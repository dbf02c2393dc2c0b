// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_io.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/preset/rejection.h"
#include "texgen/image/png.h"
#include "texgen/preset/conditions.h"
#include "texgen/preset/preset_keys.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace foam::texgen {
namespace {

std::string failure(const std::string& toml) {
    return test::rejection_of([&] { parse_preset(toml, "a", "a.toml"); });
}

std::string set_failure(const std::vector<std::string>& arguments) {
    Preset preset;
    std::vector<Assignment> assignments;
    assignments.reserve(arguments.size());
    for (const std::string& argument : arguments) {
        assignments.push_back(read_set_argument(argument));
    }
    return test::rejection_of([&] { assign(preset, assignments); });
}

TEST(PresetIo, ReadsEveryKind) {
    const Preset preset = parse_preset(
        "[preset]\ndescription = \"d\"\n[foam]\nbubbles = 50\nseed = 9\n"
        "[dynamics]\nkappa = 2\n[image]\nsize = [64, 32]\n"
        "[albedo]\npressure_unit = \"seed\"\n",
        "mine",
        "mine.toml");
    EXPECT_EQ(preset.name, "mine");
    EXPECT_EQ(preset.description, "d");
    EXPECT_EQ(preset.seeding.bubbles, 50);
    EXPECT_EQ(preset.seeding.seed, 9U);
    EXPECT_DOUBLE_EQ(preset.coarsening.kappa, 2.0);
    EXPECT_EQ(preset.image.width, 64);
    EXPECT_EQ(preset.image.height, 32);
    EXPECT_EQ(preset.maps.albedo.pressure_unit, PressureUnit::Seed);
    EXPECT_EQ(preset.frames.count, FramesOptions{}.count);
}

TEST(PresetIo, ErrorNamesLocationKeyValueAndLimits) {
    EXPECT_EQ(failure("[foam]\n\nbubbles = -3\n"),
              "a.toml:3: key 'foam.bubbles' = -3: must be an integer from 4 to 1000000");
    EXPECT_EQ(set_failure({"foam.bubbles=-3"}),
              "--set foam.bubbles=-3: key 'foam.bubbles' = -3: "
              "must be an integer from 4 to 1000000");
    EXPECT_EQ(failure("[albedo]\nfilm_unit = \"mm\"\n"),
              "a.toml:2: key 'albedo.film_unit' = \"mm\": must be one of \"px\", \"diameter\"");
}

// The table albedo.colors takes the place of the list. A preset's TOML has only one of them.
TEST(PresetIo, ColorsMayComeFromAPicture) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.png").string();
    write_file(path, encode_png(Image<std::uint8_t>(2, 1, 1).view()));
    const Preset preset = parse_preset(
        "[albedo]\ncolors = { from = \"" + path + "\", count = 3 }\n", "mine", "mine.toml");
    EXPECT_EQ(preset.maps.albedo.colors, std::vector<std::string>{"#000000"});
    const std::string toml = to_toml(preset);
    EXPECT_NE(toml.find("\ncolors.from = "), std::string::npos);
    EXPECT_NE(toml.find("\ncolors.count = 3\n"), std::string::npos);
    const std::size_t albedo = toml.find("[albedo]\n");
    EXPECT_EQ(toml.substr(albedo, toml.find("\n[lit]") - albedo).find("\ncolors = "),
              std::string::npos);
    EXPECT_EQ(to_toml(parse_preset(toml, "mine", "mine.toml")), toml);
    EXPECT_EQ(to_toml(Preset()).find("colors.from"), std::string::npos);
}

TEST(PresetIo, RejectsUnknownKeysOfTheTableOfColors) {
    EXPECT_EQ(failure("[albedo]\ncolors = { form = \"a.png\" }\n"),
              "a.toml:2: key 'albedo.colors.form' = \"a.png\": unknown key; did you mean "
              "'albedo.colors.from'?");
    EXPECT_NE(set_failure({"albedo.colors.from=missing.png"}).find("missing.png"),
              std::string::npos);
}

TEST(PresetIo, AnUnknownKeySuggestsTheNearest) {
    EXPECT_EQ(failure("[foam]\nbubles = 3\n"),
              "a.toml:2: key 'foam.bubles' = 3: unknown key; did you mean 'foam.bubbles'?");
    EXPECT_EQ(failure("kappa = 3\n"),
              "a.toml:1: key 'kappa' = 3: unknown key; did you mean 'dynamics.kappa'?");
    EXPECT_EQ(failure("[foam]\nzzzzzz = 3\n"),
              "a.toml:2: key 'foam.zzzzzz' = 3: unknown key; "
              "'foamtex presets keys' lists all keys");
}

TEST(PresetIo, ATableTakesNoValue) {
    EXPECT_EQ(set_failure({"albedo={colormap=\"magma\", x=3}"}),
              "--set albedo={colormap=\"magma\", x=3}: key 'albedo' = \"{colormap=\\\"magma\\\", "
              "x=3}\": is a table; 'foamtex presets keys albedo' lists its keys");
    EXPECT_EQ(failure("foam = 3\n"),
              "a.toml:1: key 'foam' = 3: is a table; 'foamtex presets keys foam' lists its keys");
    EXPECT_NE(set_failure({"albedo.colors={from=\"a.png\"}"}), "no failure");
    EXPECT_EQ(failure("[foam]\n"), "no failure");
}

TEST(PresetIo, AMisspelledWordSuggestsTheNearest) {
    EXPECT_EQ(failure("[relief]\nprofile = \"wett\"\n"),
              "a.toml:2: key 'relief.profile' = \"wett\": must be one of \"dome\", \"ridge\", "
              "\"wet\"; did you mean 'wet'?");
    for (const auto& [argument, meant] : {std::pair("albedo.colormap=viridiss", "viridis"),
                                          std::pair("image.maps=albdo", "albedo"),
                                          std::pair("image.maps=['height','albdo']", "albedo"),
                                          std::pair("foam.outline=disk", "disc")}) {
        const std::string message = set_failure({argument});
        EXPECT_TRUE(message.ends_with(fmt::format("; did you mean '{}'?", meant))) << message;
    }
    EXPECT_EQ(set_failure({"image.maps=['height','height']"}).find("did you mean"),
              std::string::npos);
}

TEST(PresetIo, RejectsAnUnknownTableEvenIfEmpty) {
    EXPECT_EQ(failure("[foam]\n[beer]\n"),
              "a.toml:2: key 'beer' = {...}: unknown table; "
              "'foamtex presets keys' lists all keys");
    EXPECT_EQ(failure("[foam]\n"), "no failure");
}

TEST(PresetIo, RejectsATableForAValueAndAValueForATable) {
    EXPECT_EQ(failure("[foam.bubbles]\n"),
              "a.toml:1: key 'foam.bubbles' = {...}: must be an integer from 4 to 1000000");
    EXPECT_NE(failure("foam = 3\n"), "no failure");
}

TEST(PresetIo, ALongValueIsCutToOneReadableLine) {
    const std::string message =
        failure("[albedo]\nfilm_profile = \"" + std::string(500, 'x') + "\"\n");
    EXPECT_LT(message.size(), 250U);
    EXPECT_NE(message.find("xxx...: must be one of"), std::string::npos);
}

TEST(PresetIo, RejectsAnImageMuchLongerThanWide) {
    EXPECT_EQ(set_failure({"image.size=[1024,64]"}), "no failure");
    EXPECT_EQ(set_failure({"image.size=[64,1025]"}),
              "--set image.size=[64,1025]: key 'image.size' = [64, 1025]: "
              "the longer side must be at most 16 times the shorter side");
}

TEST(PresetIo, ThePressureRangeIsCheckedAfterAllAssignments) {
    EXPECT_EQ(set_failure({"albedo.pressure_low=2", "albedo.pressure_high=3"}), "no failure");
    EXPECT_EQ(
        failure("[albedo]\npressure_low = 0.5\npressure_high = 0.25\n"),
        "a.toml:3: key 'albedo.pressure_high' = 0.25: must be above albedo.pressure_low = 0.5");
    EXPECT_EQ(set_failure({"albedo.pressure_low=0.5"}),  // the default of pressure_high
              "--set albedo.pressure_low=0.5: key 'albedo.pressure_low' = 0.5: "
              "must be below albedo.pressure_high = 0.5");
}

TEST(PresetIo, KeysOfTheOtherKindOfFoamAreRejected) {
    EXPECT_EQ(set_failure({"foam.outline=rectangle"}),
              "--set foam.outline=rectangle: key 'foam.outline' = \"rectangle\": "
              "foam.outline is only allowed with foam.domain = \"patch\"");
    EXPECT_EQ(set_failure({"foam.outline=rectangle", "foam.domain=patch"}), "no failure");
    EXPECT_EQ(set_failure({"foam.outline=disc"}), "no failure");
    EXPECT_NE(set_failure({"camera.zoom=2"}), "no failure");
    EXPECT_EQ(set_failure({"camera.zoom=2", "foam.domain=patch"}), "no failure");
}

TEST(PresetIo, BlamesAKindThatConflictsWithOtherKeys) {
    Preset preset = parse_preset("[foam]\ndomain = \"patch\"\n[camera]\nzoom = 4\n", "a", "a.toml");
    EXPECT_EQ(test::rejection_of(
                  [&] { assign(preset, std::vector{read_set_argument("foam.domain=torus")}); }),
              "--set foam.domain=torus: key 'foam.domain' = \"torus\": "
              "camera.zoom is only allowed with foam.domain = \"patch\"");
}

TEST(PresetIo, TheLaterAssignmentWins) {
    Preset preset;
    assign(preset, std::vector{read_set_argument("foam.seed=3"), read_set_argument("foam.seed=4")});
    EXPECT_EQ(preset.seeding.seed, 4U);
}

// Of albedo.colors and albedo.colors.from, only the one that is used is written.
TEST(PresetIo, EveryMemberIsWritten) {
    const std::string toml = to_toml(Preset{});
    for (const KeyInfo& key : preset_keys()) {
        const bool is_written = toml.find(fmt::format("\n{} = ", key.name())) != std::string::npos;
        EXPECT_EQ(is_written, !key.written || is_met(*key.written, Preset{})) << key.path;
    }
}

RC_GTEST_PROP(PresetIo, RoundTrips, ()) {
    Preset preset;
    preset.description = *rc::gen::container<std::string>(rc::gen::inRange<char>(1, 127));
    preset.seeding.bubbles = *rc::gen::inRange(4, 1'000'001);
    preset.seeding.seed = *rc::gen::inRange<std::uint64_t>(0, std::uint64_t{1} << 63);
    preset.coarsening.kappa = *rc::gen::inRange(0, 1'000'000) / 1007.0;
    preset.image.width = *rc::gen::inRange(64, 16385);
    preset.maps.albedo.pressure_low = -*rc::gen::inRange(1, 1'000'000) / 3.0;
    preset.maps.albedo.film_unit = *rc::gen::element(WidthUnit::Pixels, WidthUnit::Diameters);

    const Preset back = parse_preset(to_toml(preset), preset.name, "back");
    RC_ASSERT(back.description == preset.description);
    RC_ASSERT(back.seeding.bubbles == preset.seeding.bubbles);
    RC_ASSERT(back.seeding.seed == preset.seeding.seed);
    RC_ASSERT(back.coarsening.kappa == preset.coarsening.kappa);
    RC_ASSERT(back.image.width == preset.image.width);
    RC_ASSERT(back.maps.albedo.pressure_low == preset.maps.albedo.pressure_low);
    RC_ASSERT(back.maps.albedo.film_unit == preset.maps.albedo.film_unit);
    RC_ASSERT(to_toml(back) == to_toml(preset));
}

TEST(PresetIo, TheReferenceHasDefaultMeaningAndLimitsOfEveryKey) {
    const std::string reference = describe_keys();
    for (const KeyInfo& key : preset_keys()) {
        EXPECT_NE(reference.find(key.meaning), std::string::npos) << key.path;
        EXPECT_NE(reference.find(key.allowed), std::string::npos) << key.path;
    }
    EXPECT_NE(reference.find("[foam]\ndomain = \"torus\"\n"), std::string::npos);
    EXPECT_NE(reference.find("outline = \"disc\"\n"), std::string::npos);
    EXPECT_NE(reference.find("    only with foam.domain = \"patch\"\n"), std::string::npos);
}

TEST(PresetIo, ColorsByAPictureNeedAPicture) {
    EXPECT_EQ(test::rejection_of(
                  [] { parse_preset("[albedo]\ncolor_by = \"picture\"\n", "x", "x.toml"); }),
              "x.toml:2: key 'albedo.color_by' = \"picture\": albedo.color_by = \"picture\" needs "
              "albedo.picture, the path of a picture");
}

}  // namespace
}  // namespace foam::texgen
