// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

TEST(AlbedoOptions, LimitsHoldOnBothSides) {
    test::expect_limits(albedo_keys(),
                        {{"pressure_low", "-1e7", "-1e6", "1e6", "1e7"},
                         {"film_width", "-1", "0", "1000", "1001"},
                         {"variation", "-0.1", "0", "1", "1.1"},
                         {"shade", "-0.1", "0", "1", "1.1"},
                         {"shade_width", "0", "0.001", "10", "11"}});
}

TEST(AlbedoOptions, ChoicesHaveTheirWords) {
    test::expect_words(albedo_keys(), "color_by", {"pressure", "area", "sides", "random"});
    test::expect_words(albedo_keys(), "color_mix", {"blend", "pick"});
    test::expect_words(albedo_keys(), "film_profile", {"even", "wet"});
    test::expect_words(albedo_keys(), "film_unit", {"px", "diameter"});
    test::expect_words(albedo_keys(), "pressure_unit", {"seed", "current"});
}

TEST(AlbedoOptions, AColorMapReplacesColorsThatWereSetBefore) {
    const auto set = [](AlbedoOptions& options, std::string_view path, const Value& value) {
        for (const Key<AlbedoOptions>& key : albedo_keys()) {
            if (key.path == path) {
                EXPECT_TRUE(key.read(value, options)) << path;
            }
        }
    };
    const Value colors{Value::List{Value{std::string("#112233")}}};
    AlbedoOptions options;
    set(options, "colors", colors);
    set(options, "colormap", Value{std::string("magma")});
    EXPECT_TRUE(options.colors.empty());
    EXPECT_EQ(options.colormap, "magma");
    set(options, "colors", colors);
    EXPECT_EQ(options.colors, std::vector<std::string>{"#112233"});
}

}  // namespace
}  // namespace foam::texgen
