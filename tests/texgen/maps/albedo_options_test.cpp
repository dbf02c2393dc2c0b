// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/albedo_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace foam::texgen
