// SPDX-License-Identifier: Apache-2.0

#include "tests/support/temporary_folder.h"
#include "tests/support/test_files.h"
#include "tests/texgen/pictures.h"
#include "texgen/bake/bake.h"
#include "texgen/image/png.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <ostream>
#include <string>

namespace foam::texgen {

namespace {

// Compares a frame of each shipped preset, drawn at a smaller size, with the picture in
// tests/data/golden. If FOAMTEX_UPDATE_GOLDEN is set, replaces the pictures instead; look at them
// before a commit.
struct GoldenCase {
    const char* preset;
    int frame;
};

std::ostream& operator<<(std::ostream& out, const GoldenCase& golden) {
    return out << golden.preset;
}

class GoldenTest : public testing::TestWithParam<GoldenCase> {};

std::filesystem::path golden_path(const std::string& preset) {
    return foam::test::data_folder() / "golden" / (preset + ".png");
}

std::filesystem::path baked_path(const GoldenCase& golden, const TemporaryFolder& folder) {
    Preset preset = load_preset(golden.preset);
    preset.image.width = 256;
    preset.image.height = 256;
    preset.image.maps.resize(1);
    preset.output.pattern = (folder.path() / "{preset}.png").string();
    return bake(preset, {.frames = {golden.frame}, .threads = 2}, {}).files.front();
}

TEST_P(GoldenTest, PresetGivesThePicture) {
    const TemporaryFolder folder;
    const std::filesystem::path baked = baked_path(GetParam(), folder);
    const std::filesystem::path golden = golden_path(GetParam().preset);
    if (std::getenv("FOAMTEX_UPDATE_GOLDEN") != nullptr) {
        std::filesystem::copy_file(
            baked, golden, std::filesystem::copy_options::overwrite_existing);
        GTEST_SKIP() << "made " << golden << " anew";
    }
    const Image<std::uint8_t> expected = codes8(read_picture(golden));
    const Image<std::uint8_t> actual = codes8(read_picture(baked));
    ASSERT_EQ(actual.width(), expected.width());
    ASSERT_EQ(actual.height(), expected.height());
    const auto differing = [&] {
        std::size_t count = 0;
        for (std::size_t k = 0; k < expected.samples().size(); ++k) {
            count += expected.samples()[k] != actual.samples()[k] ? 1U : 0U;
        }
        return count;
    };
    EXPECT_EQ(differing(), 0U) << "samples differ from " << golden;
}

INSTANTIATE_TEST_SUITE_P(Presets,
                         GoldenTest,
                         testing::Values(GoldenCase{"sea_foam", 3},
                                         GoldenCase{"surf", 12},
                                         GoldenCase{"beer_head", 1},
                                         GoldenCase{"fizz", 20},
                                         GoldenCase{"bath_bubbles", 1},
                                         GoldenCase{"iridescent", 1},
                                         GoldenCase{"caustics", 9},
                                         GoldenCase{"sea_ice", 1},
                                         GoldenCase{"lava", 2},
                                         GoldenCase{"pebbles", 1},
                                         GoldenCase{"basalt", 1},
                                         GoldenCase{"dried_mud", 1},
                                         GoldenCase{"dragon_skin", 1},
                                         GoldenCase{"giraffe", 1},
                                         GoldenCase{"leather", 1},
                                         GoldenCase{"cell_tissue", 1},
                                         GoldenCase{"honeycomb", 30},
                                         GoldenCase{"potion", 1},
                                         GoldenCase{"stained_glass", 5},
                                         GoldenCase{"toon_bubbles", 1},
                                         GoldenCase{"force_field", 12},
                                         GoldenCase{"labyrinth", 1},
                                         GoldenCase{"maze", 1},
                                         GoldenCase{"maze_relief", 1},
                                         GoldenCase{"coarsening", 2},
                                         GoldenCase{"collapse", 24},
                                         GoldenCase{"shear", 25},
                                         GoldenCase{"relax", 2},
                                         GoldenCase{"soap_raft", 30}),
                         [](const auto& tested) { return std::string(tested.param.preset); });

TEST(Golden, EveryShippedPresetHasAPicture) {
    for (const ShippedPreset& preset : shipped_presets()) {
        EXPECT_TRUE(std::filesystem::exists(golden_path(std::string(preset.name)))) << preset.name;
    }
}

}  // namespace

}  // namespace foam::texgen
