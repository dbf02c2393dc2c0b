// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/output_options.h"

#include "tests/texgen/keys/limits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace foam::texgen {
namespace {

TEST(OutputOptions, LimitsHoldOnBothSides) {
    test::expect_limits(
        output_keys(),
        {{"frames_per_second", "0", "1", "1000", "1001"}, {"exr_level", "0", "1", "9", "10"}});
}

TEST(OutputOptions, NamesAreWordsForMaps) {
    EXPECT_EQ(parse_named_map("albedo=Base-Color_1").map, "albedo");
    EXPECT_EQ(parse_named_map("albedo=Base-Color_1").word, "Base-Color_1");
    for (const char* wrong : {"albedo", "albdo=A", "albedo=", "albedo=a/b", "=A", "ORM=A"}) {
        EXPECT_THROW(parse_named_map(wrong), std::invalid_argument) << wrong;
    }
}

TEST(OutputOptions, SheetPatternsNeedTheMapInTheirFileName) {
    const Keys<OutputOptions> keys = output_keys();
    const auto key = std::ranges::find(keys, "sheet_pattern", &KeyInfo::path);
    OutputOptions options;
    EXPECT_TRUE(key->read({"a/{preset}/{map}_x"}, options));
    EXPECT_EQ(options.sheet_pattern, "a/{preset}/{map}_x");
    EXPECT_FALSE(key->read({"a/{map}/x"}, options));
    EXPECT_FALSE(key->read({"x"}, options));
    EXPECT_FALSE(key->read({true}, options));
}

TEST(OutputOptions, PackingsAndNamesAreListsOrSingleTexts) {
    for (const auto& [name, text] : {std::pair("pack", "X=0,0,1"), std::pair("names", "id=I")}) {
        const Keys<OutputOptions> keys = output_keys();
        const auto key = std::ranges::find(keys, name, &KeyInfo::path);
        ASSERT_NE(key, keys.end());
        OutputOptions options;
        EXPECT_TRUE(key->read({text}, options));
        EXPECT_EQ(to_toml(*key->write(options)), '[' + to_toml(Value{text}) + ']');
        EXPECT_TRUE(key->read({Value::List{{text}}}, options));
        EXPECT_FALSE(key->read({"X"}, options));
        EXPECT_FALSE(key->read({Value::List{{text}, {"X"}}}, options));
        EXPECT_NE(key->fault({Value::List{{text}, {"X"}}}), "");
        EXPECT_TRUE(key->read({Value::List{}}, options));
        EXPECT_TRUE(key->is_default(options));
    }
}

TEST(OutputOptions, ScenesAreAListOfFormatsThatMayBeEmpty) {
    const Keys<OutputOptions> keys = output_keys();
    const auto key = std::ranges::find(keys, "scene", &KeyInfo::path);
    OutputOptions options;
    EXPECT_TRUE(key->is_default(options));
    EXPECT_TRUE(key->read({"usda"}, options));
    EXPECT_TRUE(key->read({Value::List{{"gltf"}, {"mtlx"}}}, options));
    EXPECT_EQ(options.scene, (std::vector<std::string>{"gltf", "mtlx"}));
    EXPECT_EQ(to_toml(*key->write(options)), "[\"gltf\", \"mtlx\"]");
    for (const Value& wrong : {Value{"glb"}, Value{Value::List{{"usda"}, {"usda"}}}, Value{true}}) {
        EXPECT_FALSE(key->read(wrong, options));
    }
    EXPECT_EQ(options.scene.size(), 2U);
    EXPECT_TRUE(key->read({Value::List{}}, options));
    EXPECT_TRUE(options.scene.empty());
}

TEST(OutputOptions, ChoicesHaveTheirWords) {
    test::expect_words(output_keys(), "texts", {"written", "left-out"});
    test::expect_words(output_keys(), "png_compression", {"fast", "small", "none"});
    test::expect_words(output_keys(), "exr_compression", {"zip", "zips", "piz", "rle", "none"});
    test::expect_words(output_keys(), "exr_numbers", {"float", "half"});
    test::expect_words(output_keys(), "exr_layout", {"rows", "mip-levels"});
    test::expect_words(output_keys(), "sheets", {"none", "grid", "strip", "dds", "ktx2"});
    test::expect_words(output_keys(), "block_compression", {"auto", "none"});
    test::expect_words(output_keys(), "mip_levels", {"on", "off"});
}

}  // namespace
}  // namespace foam::texgen
