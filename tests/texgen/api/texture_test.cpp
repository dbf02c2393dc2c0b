// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"

#include <foamtex/texture.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace foamtex {
namespace {

using Values = std::map<std::string, std::string>;

Values small(const Values& more = {}) {
    Values values{{"foam.bubbles", "30"}, {"image.size", "[32, 32]"}, {"frames.count", "3"}};
    values.insert(more.begin(), more.end());
    return values;
}

std::vector<int> numbers_of(Simulation& simulation) {
    std::vector<int> numbers;
    while (const auto frame = simulation.next()) {
        numbers.push_back(frame->number());
    }
    return numbers;
}

Frame first_frame(const Preset& preset) {
    return Simulation(preset, "1").next().value();
}

TEST(LibraryPreset, HasValuesOfKeys) {
    Preset preset("sea_foam", small());
    EXPECT_EQ(preset.get("foam.bubbles"), "30");
    EXPECT_EQ(preset.width(), 32);
    EXPECT_EQ(preset.frame_count(), 3);
    preset.set({{"foam.seed", "9"}});
    EXPECT_EQ(preset.get("foam.seed"), "9");
    EXPECT_NE(preset.toml().find("seed = 9"), std::string::npos);
    EXPECT_EQ(preset.seeded_foam().bubble_count(), 30);
}

// A preset is unchanged if one of several values is not allowed.
TEST(LibraryPreset, IsUnchangedAfterAnError) {
    Preset preset("sea_foam", small());
    EXPECT_THROW(preset.set({{"foam.bubbles", "31"}, {"foam.seed", "-x"}}), ArgumentError);
    EXPECT_EQ(preset.get("foam.bubbles"), "30");
    EXPECT_THROW(Preset("sea_form"), ArgumentError);
    EXPECT_THROW(Preset("missing.toml"), ArgumentError);
    EXPECT_THROW(preset.get("foam.x"), ArgumentError);
}

TEST(LibrarySimulation, GivesTheFramesInOrder) {
    const Preset preset("sea_foam", small());
    Simulation all(preset);
    EXPECT_EQ(numbers_of(all), (std::vector{1, 2, 3}));
    EXPECT_FALSE(all.next());  // also later
    Simulation some(preset, "1-3x2");
    EXPECT_EQ(numbers_of(some), (std::vector{1, 3}));
    EXPECT_THROW(Simulation(preset, "x"), ArgumentError);
}

TEST(LibrarySimulation, MayBeLeftEarlyOrMoved) {
    const Preset preset("sea_foam", small({{"frames.count", "100"}, {"loop.kind", "none"}}));
    Simulation simulation(preset);
    ASSERT_TRUE(simulation.next());
    Simulation moved = std::move(simulation);
    ASSERT_TRUE(moved.next());
}

TEST(LibrarySimulation, ReportsALoopThatDoesNotClose) {
    const Preset preset(
        "sea_foam",
        small({{"loop.kind", "breathe"}, {"loop.amplitude", "0.9"}, {"loop.cycles", "1"}}));
    Simulation simulation(preset);
    EXPECT_THROW(simulation.next(), EquilibriumError);
}

TEST(LibrarySimulation, EndsWithAnExceptionOfThePoll) {
    const Preset preset("sea_foam", {{"foam.bubbles", "20000"}, {"loop.kind", "none"}});
    Simulation simulation(preset, "50");
    const auto fail = [] { throw std::domain_error("enough"); };
    EXPECT_THROW(simulation.next(fail), std::domain_error);
}

TEST(LibraryFrame, DrawsMapsIntoBuffers) {
    Preset preset("lava", small());
    preset.fit_ranges();
    const Frame frame = first_frame(preset);
    ASSERT_EQ(frame.shape("albedo").channels, 3);
    std::vector<float> light(frame.shape("albedo").size());
    frame.draw("albedo", std::span(light));
    EXPECT_GT(*std::ranges::max_element(light), 0.0F);
    EXPECT_LE(*std::ranges::max_element(light), 1.0F);
    std::vector<std::uint16_t> heights(frame.shape("height", true).size());
    frame.draw("height", std::span(heights));
    EXPECT_GT(*std::ranges::max_element(heights), 1000);
    light.pop_back();
    EXPECT_THROW(frame.draw("albedo", std::span(light)), ArgumentError);
    EXPECT_THROW(frame.draw("albdeo", std::span(light)), ArgumentError);
    EXPECT_EQ(frame.records().bubbles.size(), 30U);
}

// The map of motion has two channels, which a PNG stores as three.
TEST(LibraryFrame, ShapesAreThoseOfTheSamples) {
    const Frame torus = first_frame(Preset("sea_foam", small({{"image.maps", "[\"motion\"]"}})));
    EXPECT_EQ(torus.shape("motion").channels, 2);
    EXPECT_EQ(torus.shape("motion", true).channels, 3);
    std::vector<float> motion(torus.shape("motion").size());
    torus.draw("motion", std::span(motion));
    const Frame patch = first_frame(Preset("soap_raft", small()));
    EXPECT_EQ(patch.shape("albedo").channels, 4);
    EXPECT_FALSE(patch.extent().is_torus());
}

// The preset labyrinth has a color map for pressures.
TEST(LibraryFrame, DrawsPressuresWithAColorMapAsColors) {
    const Frame frame = first_frame(Preset("labyrinth", small()));
    EXPECT_EQ(frame.shape("pressure").channels, 3);
    EXPECT_EQ(frame.shape("pressure", true).channels, 3);
    std::vector<std::uint8_t> codes(frame.shape("pressure", true).size());
    frame.draw("pressure", std::span(codes));
    std::vector<float> light(frame.shape("pressure").size());
    frame.draw("pressure", std::span(light));
    EXPECT_GT(*std::ranges::max_element(light), 0.0F);
    std::vector<std::uint16_t> long_codes(light.size());
    EXPECT_THROW(frame.draw("pressure", std::span(long_codes)), ArgumentError);
}

TEST(LibraryFrame, NamesWhatIsMissing) {
    const Frame frame = first_frame(Preset("sea_foam", small()));
    std::vector<float> motion(frame.shape("motion").size());
    EXPECT_THROW(frame.draw("motion", std::span(motion)), ArgumentError);  // no next frame
    std::vector<std::uint8_t> codes(frame.shape("height", true).size());
    EXPECT_THROW(frame.draw("height", std::span(codes)), ArgumentError);  // automatic range
    std::vector<std::uint16_t> colors(frame.shape("albedo", true).size());
    EXPECT_THROW(frame.draw("albedo", std::span(colors)), ArgumentError);
}

TEST(LibraryBake, WritesFilesAndTheManifest) {
    const foam::TemporaryFolder folder;
    const Preset preset("sea_foam", small({{"image.maps", "[\"albedo\"]"}}));
    int calls = 0;
    const std::vector<std::string> files =
        bake(preset, folder.path().string(), {.frames = "1-2", .on_progress = [&](const Progress&) {
                                                  ++calls;
                                              }});
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(std::filesystem::path(files[1]).filename(), "sea_foam_albedo.0002.png");
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "manifest.json"));
    EXPECT_GT(calls, 2);
    const std::string pattern = (folder.path() / "x" / "{map}.##.png").string();
    EXPECT_EQ(bake(preset, pattern, {.frames = "3"}).front(),
              (folder.path() / "x" / "albedo.03.png").string());
    EXPECT_THROW(bake(preset, "/proc/none"), OutputError);

    const std::vector<Difference> same = compare(files[0], files[0]);
    ASSERT_EQ(same.size(), 1U);
    EXPECT_TRUE(same[0].is_within);
    const std::vector<Difference> other = compare(files[0], files[1]);
    EXPECT_FALSE(other[0].is_within);
    EXPECT_FALSE(other[0].reasons.empty());
    EXPECT_TRUE(compare(files[0], files[1], {.sample = 1.0})[0].is_within);
    EXPECT_THROW(compare(files[0], "missing.png"), InputError);
}

// The folder replaces "out", but not the folders of the maps.
TEST(LibraryBake, AFolderKeepsTheFoldersOfMaps) {
    const foam::TemporaryFolder folder;
    const Preset preset("sea_foam",
                        small({{"image.maps", "[\"albedo\", \"film\"]"},
                               {"output.pattern", "out/{map}/####.png"}}));
    const std::vector<std::string> files = bake(preset, folder.path().string(), {.frames = "1"});
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[0], (folder.path() / "albedo" / "0001.png").string());
    EXPECT_EQ(files[1], (folder.path() / "film" / "0001.png").string());
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "manifest.json"));
}

TEST(LibraryInformation, NamesPresetsMapsAndKeys) {
    const std::string wanted = FOAMTEX_VERSION;
    EXPECT_EQ(version(), wanted);
    EXPECT_GE(algorithm_version(), 1);
    EXPECT_TRUE(std::ranges::count(preset_names(), "sea_foam"));
    EXPECT_TRUE(std::ranges::count(maps(), "height", &MapInfo::name));
    EXPECT_NE(key_schema().find("\"foam\""), std::string::npos);
}

}  // namespace
}  // namespace foamtex
