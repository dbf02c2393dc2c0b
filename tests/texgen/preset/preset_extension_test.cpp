// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/preset_extension.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam::texgen {
namespace {

TEST(PresetExtension, SetsTheKeysInOrder) {
    const std::vector<Assignment> assignments = {read_set_argument("loop.current=0.4"),
                                                 read_set_argument("foam.seed=3"),
                                                 read_set_argument("foam.bubbles=90"),
                                                 read_set_argument("foam.seed=5")};
    EXPECT_EQ(extending_preset("lava", assignments),
              "extends = \"lava\"\n"
              "\n[foam]\nbubbles = 90\nseed = 5\n"
              "\n[loop]\ncurrent = 0.4\n");
}

// TOML can contain either the list or the table: the last assignment counts.
TEST(PresetExtension, WritesEitherAListOrATable) {
    const Assignment list = read_set_argument("albedo.colors=[\"#112233\"]");
    const Assignment picture = read_set_argument("albedo.colors.from=a.png");
    EXPECT_EQ(extending_preset("lava", std::vector{list, picture}),
              "extends = \"lava\"\n\n[albedo]\ncolors.from = \"a.png\"\n");
    EXPECT_EQ(extending_preset("lava", std::vector{picture, list}),
              "extends = \"lava\"\n\n[albedo]\ncolors = [\"#112233\"]\n");
}

TEST(PresetExtension, QuotesThePathOfThePreset) {
    EXPECT_EQ(extending_preset("../a \"b\".toml", {}), "extends = \"../a \\\"b\\\".toml\"\n");
}

}  // namespace
}  // namespace foam::texgen
