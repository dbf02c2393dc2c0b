// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/random_variations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

namespace foam::texgen {
namespace {

Preset with(std::vector<std::string> vary) {
    Preset preset;
    preset.name = "mine";
    preset.vary = std::move(vary);
    return preset;
}

std::string text_of(const Variation& variation) {
    std::string text;
    for (const Assignment& one : variation.assignments) {
        text += one.key + '=' + to_toml(one.value) + ' ';
    }
    return text;
}

// Returns how often each value of a key occurs.
std::map<std::string, int> values_of(const std::vector<Variation>& variations,
                                     const std::string& key) {
    std::map<std::string, int> values;
    for (const Variation& variation : variations) {
        for (const Assignment& one : variation.assignments) {
            if (one.key == key) {
                ++values[to_toml(one.value)];
            }
        }
    }
    return values;
}

// Each of three values has an expected count of 100 and a standard deviation of 8.2.
TEST(RandomVariations, AllValuesOfAListAreEquallyLikely) {
    const Preset preset = with({"foam.lloyd=0,3,7", "loop.amplitude=0.1..0.3:3"});
    const auto variations = random_variations(preset, {.count = 300});
    for (const char* key : {"foam.lloyd", "loop.amplitude"}) {
        const std::map<std::string, int> counts = values_of(variations, key);
        EXPECT_EQ(counts.size(), 3U);
        for (const auto& [value, count] : counts) {
            EXPECT_NEAR(count, 100, 35) << key << ' ' << value;
        }
    }
}

TEST(RandomVariations, ARangeIsCovered) {
    const auto variations = random_variations(with({"loop.amplitude=0.1..0.4"}), {.count = 300});
    double smallest = 1.0;
    double largest = 0.0;
    double sum = 0.0;
    for (const Variation& variation : variations) {
        const double value = std::get<double>(variation.assignments.back().value.data);
        smallest = std::min(smallest, value);
        largest = std::max(largest, value);
        sum += value;
    }
    EXPECT_GE(smallest, 0.1);
    EXPECT_LE(smallest, 0.12);
    EXPECT_LE(largest, 0.4);
    EXPECT_GE(largest, 0.38);
    EXPECT_NEAR(sum / 300, 0.25, 0.02);  // four standard errors: 4 * 0.3 / sqrt(12 * 300)
}

TEST(RandomVariations, EveryVariationHasItsOwnFoam) {
    const auto variations = random_variations(with({"foam.lloyd=0,1"}), {});
    EXPECT_EQ(variations.size(), 12U);
    EXPECT_GE(values_of(variations, "foam.seed").size(), 10U);
    EXPECT_EQ(variations.front().assignments.front().key, "foam.seed");
    const auto listed = random_variations(with({"foam.lloyd=0,1", "foam.seed=5,6"}), {});
    EXPECT_EQ(values_of(listed, "foam.seed").size(), 2U);
}

TEST(RandomVariations, DependOnlyOnTheSeedAndTheList) {
    const Preset preset = with({"foam.lloyd=0,1,2,3,4", "loop.amplitude=0.1..0.4"});
    const auto twelve = random_variations(preset, {.seed = 3});
    const auto thirty = random_variations(preset, {.count = 30, .seed = 3});
    const auto others = random_variations(preset, {.seed = 4});
    int different = 0;
    for (std::size_t k = 0; k < twelve.size(); ++k) {
        EXPECT_EQ(text_of(twelve[k]), text_of(thirty[k]));
        different += text_of(twelve[k]) != text_of(others[k]) ? 1 : 0;
    }
    EXPECT_GE(different, 10);
    // Golden values: a change of the generator or of the order of draws would change the sheets.
    EXPECT_EQ(text_of(random_variations(preset, {}).front()),
              "foam.seed=137 foam.lloyd=2 loop.amplitude=0.37 ");
}

TEST(RandomVariations, AFixedKeyDoesNotVaryAndLeavesTheOthers) {
    const Preset preset = with({"foam.lloyd=0,1,2,3,4", "loop.amplitude=0.1..0.4"});
    const auto free = random_variations(preset, {});
    const auto fixed = random_variations(preset, {.fixed = {"foam.seed", "foam.lloyd"}});
    for (std::size_t k = 0; k < free.size(); ++k) {
        ASSERT_EQ(fixed[k].assignments.size(), 1U);
        EXPECT_EQ(fixed[k].assignments[0].value, free[k].assignments[2].value);
    }
    EXPECT_THROW(
        random_variations(preset, {.fixed = {"foam.seed", "foam.lloyd", "loop.amplitude"}}),
        PresetError);
}

TEST(RandomVariations, APresetWithoutAListIsRejected) {
    EXPECT_THROW(random_variations(with({}), {}), PresetError);
}

}  // namespace
}  // namespace foam::texgen
