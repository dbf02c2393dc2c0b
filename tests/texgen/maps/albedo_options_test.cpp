// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo_options.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/keys/limits.h"
#include "texgen/image/png.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(AlbedoOptions, LimitsHoldOnBothSides) {
    test::expect_limits(albedo_keys(),
                        {{"colors.count", "0", "1", "64", "65"},
                         {"pressure_low", "-1e7", "-1e6", "1e6", "1e7"},
                         {"film_width", "-1", "0", "1000", "1001"},
                         {"variation", "-0.1", "0", "1", "1.1"},
                         {"shade", "-0.1", "0", "1", "1.1"},
                         {"shade_width", "0", "0.001", "10", "11"}});
}

TEST(AlbedoOptions, ChoicesHaveTheirWords) {
    test::expect_words(
        albedo_keys(), "color_by", {"pressure", "area", "sides", "random", "picture"});
    test::expect_words(albedo_keys(), "color_mix", {"blend", "pick"});
    test::expect_words(albedo_keys(), "film_profile", {"even", "wet"});
    test::expect_words(albedo_keys(), "film_unit", {"px", "diameter"});
    test::expect_words(albedo_keys(), "pressure_unit", {"seed", "current"});
}

void set(AlbedoOptions& options, std::string_view path, const Value& value) {
    for (const Key<AlbedoOptions>& key : albedo_keys()) {
        if (key.path == path) {
            EXPECT_TRUE(key.read(value, options)) << path;
        }
    }
}

TEST(AlbedoOptions, AColorMapReplacesColorsThatWereSetBefore) {
    const Value colors{Value::List{Value{std::string("#112233")}}};
    AlbedoOptions options;
    set(options, "colors", colors);
    set(options, "colormap", Value{std::string("magma")});
    EXPECT_TRUE(options.colors.empty());
    EXPECT_EQ(options.colormap, "magma");
    set(options, "colors", colors);
    EXPECT_EQ(options.colors, std::vector<std::string>{"#112233"});
}

// A picture of three pixels, two of them black and one white.
std::string picture_in(const TemporaryFolder& folder) {
    const std::string path = (folder.path() / "a.png").string();
    Image<std::uint8_t> image(3, 1, 1);
    image.pixel(2, 0)[0] = 255;
    write_file(path, encode_png(image.view()));
    return path;
}

// Of colormap, colors and colors.from, the one that is set last is used.
TEST(AlbedoOptions, APictureReplacesColors) {
    const TemporaryFolder folder;
    const Value path{picture_in(folder)};
    const std::vector<std::string> two = {"#000000", "#ffffff"};
    AlbedoOptions options;
    set(options, "colors", Value{Value::List{Value{std::string("#112233")}}});
    set(options, "colors.from", path);
    EXPECT_EQ(options.colors, two);
    set(options, "colors.count", Value{std::int64_t{1}});
    EXPECT_EQ(options.colors.size(), 1U);
    set(options, "colors", Value{Value::List{Value{std::string("#112233")}}});
    EXPECT_EQ(options.colors, std::vector<std::string>{"#112233"});
    EXPECT_FALSE(options.colors_from.is_set());
    set(options, "colors.count", Value{std::int64_t{2}});
    EXPECT_EQ(options.colors, std::vector<std::string>{"#112233"});
    set(options, "colors.from", path);
    EXPECT_EQ(options.colors, two);
    set(options, "colormap", Value{std::string("magma")});
    EXPECT_TRUE(options.colors.empty());
    EXPECT_FALSE(options.colors_from.is_set());
}

TEST(AlbedoOptions, AnEmptyPictureRemovesOnlyTheColorsOfAPicture) {
    const TemporaryFolder folder;
    AlbedoOptions options;
    set(options, "colors", Value{Value::List{Value{std::string("#112233")}}});
    set(options, "colors.from", Value{std::string()});
    EXPECT_EQ(options.colors, std::vector<std::string>{"#112233"});
    set(options, "colors.from", Value{picture_in(folder)});
    set(options, "colors.from", Value{std::string()});
    EXPECT_TRUE(options.colors.empty());
    EXPECT_FALSE(options.colors_from.is_set());
}

}  // namespace
}  // namespace foam::texgen
