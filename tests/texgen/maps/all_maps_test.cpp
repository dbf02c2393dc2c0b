// SPDX-License-Identifier: Apache-2.0

// Tests of properties that all maps have in common.
#include "texgen/maps/all_maps.h"

#include "core/files/file_io.h"
#include "tests/support/readme_table.h"
#include "tests/support/test_files.h"
#include "tests/texgen/maps/map_subjects.h"
#include "tests/texgen/maps/seam.h"
#include "tests/texgen/pictures.h"
#include "texgen/image/bleed.h"
#include "texgen/image/png.h"
#include "texgen/maps/cross_fade.h"
#include "texgen/maps/quantize.h"
#include "texgen/verify/verify.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace foam::texgen {
namespace {

constexpr int kSize = 96;

// A map and the options with which it is drawn.
struct MapCase {
    std::string map;
    std::string look{};  // name of the options; empty for the defaults
    MapOptions options{};

    std::string name() const { return look.empty() ? map : map + "_" + look; }
};

void PrintTo(const MapCase& one, std::ostream* out) {
    *out << one.name();
}

MapOptions wet_and_shaded() {
    MapOptions options;
    options.albedo.color_by = ColorBy::Area;
    options.albedo.colors = {"#102040", "#f0d080"};
    options.albedo.variation = 0.2;
    options.albedo.film_width = 3.0;
    options.albedo.film_profile = FilmProfile::Wet;
    options.albedo.shade_color = "#c02010";
    options.albedo.shade = 0.8;
    options.lit.glow = 0.7;
    options.lit.light.rim = 0.3;
    return options;
}

MapOptions grained() {
    MapOptions options;
    options.albedo.grain = 0.3;
    options.albedo.grain_size = 0.2;
    options.relief.grain = 0.05;
    return options;
}

MapOptions lit_thin_film() {
    MapOptions options;
    options.lit.colors = LitColors::ThinFilm;
    options.lit.samples = 3;
    return options;
}

MapOptions glowing_thin_film() {
    MapOptions options = wet_and_shaded();
    options.lit.colors = LitColors::ThinFilm;
    return options;
}

MapOptions maze_walls_in_relief(ReliefProfile profile) {
    MapOptions options;
    options.relief.films = ReliefFilms::Walls;
    options.relief.profile = profile;
    options.relief.width = 0.06;
    options.lit.colors = LitColors::Maze;
    options.lit.glow = 0.5;
    return options;
}

// By default, the maps emission and metallic are 0 everywhere. These options make them visible.
MapOptions visible() {
    MapOptions options;
    options.lit.glow = 0.7;
    options.metallic = {.cell = 0.2, .film = 0.9};
    return options;
}

std::vector<MapCase> all_cases() {
    std::vector<MapCase> cases;
    for (const std::string_view map : map_names()) {
        const bool is_dark = map == "emission" || map == "metallic";
        cases.push_back({std::string(map), "", is_dark ? visible() : MapOptions{}});
    }
    for (const char* map :
         {"albedo", "thin_film", "lit", "emission", "film", "opacity", "roughness"}) {
        cases.push_back({map, "wet", wet_and_shaded()});
    }
    for (const char* map : {"albedo", "lit", "emission"}) {
        MapOptions shaded = wet_and_shaded();
        shaded.albedo.film_profile = FilmProfile::Even;
        cases.push_back({map, "shaded", shaded});
    }
    for (const char* map : {"albedo", "lit", "height", "normal"}) {
        cases.push_back({map, "grained", grained()});
    }
    cases.push_back({"lit", "thin_film", lit_thin_film()});
    for (const char* map : {"lit", "emission"}) {
        cases.push_back({map, "glowing_thin_film", glowing_thin_film()});
    }
    for (const char* map : {"lit", "height", "normal", "occlusion", "curvature"}) {
        cases.push_back({map, "walls", maze_walls_in_relief(ReliefProfile::Ridge)});
        cases.push_back({map, "wet_walls", maze_walls_in_relief(ReliefProfile::Wet)});
    }
    return cases;
}

class EveryMap : public testing::TestWithParam<MapCase> {};

MapImage draw_case(const MapCase& one,
                   const test::MapSubject& subject,
                   const RasterGrid& grid,
                   int threads = 1) {
    return draw(one.map, subject, grid, threads, one.options);
}

template <class Sample>
Image<Sample> shifted(const Image<Sample>& image, int shift_x, int shift_y) {
    Image<Sample> result(image.width(), image.height(), image.channels());
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const auto from =
                image.pixel((x + shift_x) % image.width(), (y + shift_y) % image.height());
            std::copy(from.begin(), from.end(), result.pixel(x, y).begin());
        }
    }
    return result;
}

// Returns the number of samples that differ.
template <class Pixels>
int differing(const Pixels& a, const MapImage& b) {
    const auto& x = a.pixels.samples();
    const auto& y = std::get<Pixels>(b).pixels.samples();
    int count = x.size() == y.size() ? 0 : -1;
    for (std::size_t k = 0; k < x.size(); ++k) {
        count += x[k] == y[k] ? 0 : 1;
    }
    return count;
}

TEST_P(EveryMap, AShiftIsCyclicToTheBit) {
    const MapImage still = draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize));
    const MapImage moved =
        draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize, 37, 91));
    std::visit(
        [&](const auto& one) {
            auto expected = one;
            expected.pixels = shifted(one.pixels, 37, 91);
            EXPECT_EQ(differing(expected, moved), 0);
        },
        still);
}

TEST_P(EveryMap, DoesNotDependOnThreads) {
    for (const auto& [subject, grid] :
         {std::pair(&test::torus_subject(), test::torus_grid(kSize)),
          std::pair(&test::patch_subject(), test::patch_grid(kSize))}) {
        const MapImage one = draw_case(GetParam(), *subject, grid, 1);
        for (const int threads : {2, 3}) {
            const MapImage many = draw_case(GetParam(), *subject, grid, threads);
            std::visit([&](const auto& image) { EXPECT_EQ(differing(image, many), 0); }, one);
        }
    }
}

// Returns the options of a case with every key of a table that its map does not use changed to the
// first of a few trial values that is allowed and differs from the present value. Keys that name a
// file are left out.
MapOptions with_unused_keys_changed(const MapCase& one, std::string_view table) {
    MapOptions changed = one.options;
    for (const Key<MapOptions>& key : map_keys()) {
        if (key.table() != table || key.names_file || key.path == "albedo.colors.from" ||
            uses_key(find_map(one.map), key.path, one.options)) {
            continue;
        }
        std::vector<Value> values;
        for (const std::string_view word : key.words) {
            values.push_back({std::string(word)});
        }
        values.insert(values.end(), {{0.37}, {3.5}, {std::int64_t{3}}, {true}, {false}});
        values.push_back({std::string("#a04080")});
        for (const Value& value : values) {
            const std::optional<Value> before = key.write(changed);
            if (key.read(value, changed) && key.write(changed) != before) {
                break;
            }
        }
    }
    return changed;
}

TEST_P(EveryMap, DependsOnlyOnTheKeysThatItUses) {
    const MapImage image = draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize));
    std::set<std::string> tables;
    for (const Key<MapOptions>& key : map_keys()) {
        tables.emplace(key.table());
    }
    EXPECT_GT(tables.size(), 1U);
    for (const std::string& table : tables) {
        MapCase other = GetParam();
        other.options = with_unused_keys_changed(other, table);
        const MapImage same = draw_case(other, test::torus_subject(), test::torus_grid(kSize));
        std::visit([&](const auto& one) { EXPECT_EQ(differing(one, same), 0) << table; }, image);
    }
}

/// Returns the largest difference between a sample and the same sample of the pixel to its left.
template <class Sample>
double largest_step(const Image<Sample>& image) {
    double largest = 0.0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 1; x < image.width(); ++x) {
            const auto here = image.pixel(x, y);
            const auto left = image.pixel(x - 1, y);
            for (std::size_t c = 0; c < here.size(); ++c) {
                largest = std::max(largest, std::abs(double(here[c]) - double(left[c])));
            }
        }
    }
    return largest;
}

/// Visits the samples of a map. Skips maps of ids, because differences of ids have no meaning.
template <class Visit>
void visit_numbers(const MapImage& image, const Visit& visit) {
    if (const auto* const colors = std::get_if<ColorPixels>(&image)) {
        visit(colors->pixels);
    } else if (const auto* const numbers = std::get_if<NumberPixels>(&image)) {
        visit(numbers->pixels);
    } else {
        GTEST_SKIP();
    }
}

TEST_P(EveryMap, DrawsSamplesOfItsKind) {
    const MapImage image = draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize));
    EXPECT_EQ(image.index(), static_cast<std::size_t>(find_map(GetParam().map).kind));
}

// With a color map, the map `pressure` draws colors instead of numbers.
TEST(PressureMap, WithAColorMapHasTheTraitsOfColors) {
    MapCase one{"pressure", "colored"};
    one.options.pressure.colormap = "viridis";
    const MapImage image = draw_case(one, test::torus_subject(), test::torus_grid(kSize));
    const MapTraits& traits = drawn_traits(find_map("pressure"), one.options);
    EXPECT_EQ(traits.kind, MapKind::Color);
    EXPECT_EQ(channel_count(traits), std::get<ColorPixels>(image).pixels.channels());
    EXPECT_EQ(drawn_traits(find_map("pressure"), {}).kind, MapKind::Number);
    EXPECT_EQ(&drawn_traits(find_map("height"), one.options), &find_map("height"));
}

TEST_P(EveryMap, HasNoSeam) {
    const MapImage image = draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize));
    visit_numbers(image,
                  [](const auto& pixels) { EXPECT_LE(test::seam_ratio(pixels), kMaxTileRatio); });
}

// A step is added along the whole border, as high as the largest step in the image, for example at
// the edge of a film. A single sample at this border looks like such an edge, but the mean over the
// border does not. The map distance is skipped because it has such a step at every pixel, the map
// opacity because it has no step on a torus.
TEST_P(EveryMap, ASeamNoStrongerThanAFilmIsFound) {
    if (GetParam().map == "distance" || GetParam().map == "opacity") {
        GTEST_SKIP();
    }
    const MapImage image = draw_case(GetParam(), test::torus_subject(), test::torus_grid(kSize));
    visit_numbers(image, [](const auto& pixels) {
        EXPECT_GT(test::seam_ratio(pixels, largest_step(pixels)), kMaxTileRatio);
    });
}

// Returns the value of the last channel outside a patch, with the default options of a map.
double value_outside(std::string_view map) {
    return map.starts_with("normal") || map == "occlusion" ? 1.0 : 0.0;
}

// Checks the last channel: for colors it is the opacity; their other channels continue the colors
// of the patch.
TEST_P(EveryMap, IsEmptyAroundAPatch) {
    const MapImage image = draw_case(GetParam(), test::patch_subject(), test::patch_grid(kSize));
    const double outside = value_outside(GetParam().map);
    std::visit(
        [&](const auto& one) {
            for (const int x : {0, kSize - 1}) {
                EXPECT_EQ(one.pixels.pixel(x, kSize - 1).back(), outside);
            }
        },
        image);
}

// Every fully transparent pixel has the color that bleed_colors gives it.
TEST_P(EveryMap, TransparentPixelsHaveColorsOfTheFoam) {
    MapImage image = draw_case(GetParam(), test::patch_subject(), test::patch_grid(kSize));
    if (auto* const colors = std::get_if<ColorPixels>(&image)) {
        const Image<std::uint16_t> drawn = colors->pixels;
        bleed_colors(colors->pixels.view(), colors->fallback);
        EXPECT_EQ(colors->pixels, drawn);
    }
}

// A map that is drawn with other maps, whose images of the distance field it does not need, has the
// same pixels.
TEST_P(EveryMap, DoesNotDependOnTheNeedsOfOtherMaps) {
    for (const test::MapSubject* const subject : {&test::torus_subject(), &test::patch_subject()}) {
        const bool is_patch = subject->frame.domain.is_plane();
        const RasterGrid grid = is_patch ? test::patch_grid(kSize) : test::torus_grid(kSize);
        FrameInput input = subject->input();
        input.distance = {
            .distance = true, .gradient = true, .smooth = SmoothImages::DistanceAndGradient};
        ShownLayers shown{{input, grid, 1}};
        const MapImage all = draw(find_map(GetParam().map), shown, GetParam().options);
        std::visit(
            [&](const auto& own) {
                EXPECT_EQ(std::get<std::remove_cvref_t<decltype(own)>>(all).pixels, own.pixels);
            },
            draw_case(GetParam(), *subject, grid));
    }
}

TEST(DistanceNeeds, AreTheSumOfTheNeedsOfAllMaps) {
    const auto needs = [](const std::vector<std::string>& names) {
        return distance_needs(names, {});
    };
    EXPECT_FALSE(needs({"id"}).distance);
    EXPECT_EQ(needs({"id"}).smooth, SmoothImages::None);
    EXPECT_TRUE(needs({"id", "distance"}).distance);
    EXPECT_EQ(needs({"height", "occlusion", "curvature"}).smooth, SmoothImages::Distance);
    EXPECT_FALSE(needs({"height"}).distance);
    EXPECT_EQ(needs({"normal", "height"}).smooth, SmoothImages::DistanceAndGradient);
}

TEST_P(EveryMap, NumbersAreFinite) {
    const MapImage image = draw_case(GetParam(), test::patch_subject(), test::patch_grid(kSize));
    if (const auto* numbers = std::get_if<NumberPixels>(&image)) {
        const auto samples = numbers->pixels.samples();
        EXPECT_TRUE(
            std::all_of(samples.begin(), samples.end(), [](float x) { return std::isfinite(x); }));
        EXPECT_LT(numbers->low, numbers->high);
    }
}

// Returns the map of a torus above the map of a patch, in one picture. The test compares it with a
// picture in tests/data/golden/maps. If FOAMTEX_UPDATE_GOLDEN is set, it replaces that picture
// instead.
Image<std::uint8_t> golden_codes(const MapCase& one) {
    const auto codes = [&](const test::MapSubject& subject, const RasterGrid& grid) {
        return std::get<Image<std::uint8_t>>(quantize(draw_case(one, subject, grid), 8).codes);
    };
    const Image<std::uint8_t> domain = codes(test::torus_subject(), test::torus_grid(kSize));
    const Image<std::uint8_t> patch = codes(test::patch_subject(), test::patch_grid(kSize));
    Image<std::uint8_t> both(kSize, 2 * kSize, patch.channels());
    for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
            std::ranges::copy(patch.pixel(x, y), both.pixel(x, y).begin());
            std::ranges::fill(both.pixel(x, y + kSize), std::uint8_t{255});
            std::ranges::copy(domain.pixel(x, y), both.pixel(x, y + kSize).begin());
        }
    }
    return both;
}

TEST_P(EveryMap, IsTheGoldenPicture) {
    const Image<std::uint8_t> codes = golden_codes(GetParam());
    const std::filesystem::path path =
        foam::test::data_folder() / "golden" / "maps" / (GetParam().name() + ".png");
    if (std::getenv("FOAMTEX_UPDATE_GOLDEN") != nullptr) {
        make_folders(path.parent_path());
        write_png(path, codes.view());
        GTEST_SKIP() << "made " << path << " anew";
    }
    EXPECT_EQ(codes8(read_picture(path)), codes);
}

INSTANTIATE_TEST_SUITE_P(Maps, EveryMap, testing::ValuesIn(all_cases()), [](const auto& tested) {
    return tested.param.name();
});

TEST(AllMaps, DescribeThemselves) {
    for (const Map& map : all_maps()) {
        EXPECT_FALSE(map.meaning.empty()) << map.name;
        EXPECT_FALSE(map.unit.empty()) << map.name;
        EXPECT_FALSE(map.channels.empty()) << map.name;
        EXPECT_TRUE(map.png_bits == 8 || map.png_bits == 16) << map.name;
        EXPECT_EQ(&find_map(map.name), &map);
    }
}

TEST(AllMaps, UnknownNameIsRejectedWithAListOfMaps) {
    try {
        find_map("hieght");
        FAIL();
    } catch (const std::invalid_argument& error) {
        const std::string message = error.what();
        EXPECT_EQ(message.find("unknown map 'hieght'; must be one of albedo, thin_film, "), 0U);
        EXPECT_TRUE(message.ends_with("; did you mean 'height'?")) << message;
    }
}

TEST(AllMaps, AreListedOnAPageOfTheReadme) {
    foam::test::expect_in_readme("texgen/maps", describe_maps_in_markdown(), "MAPS.md");
}

}  // namespace
}  // namespace foam::texgen
