// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/varied_keys.h"

#include "tests/texgen/preset/rejection.h"
#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/shipped_presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <stdexcept>
#include <string>
#include <variant>

namespace foam::texgen {
namespace {

using testing::HasSubstr;

std::string fault_of(const std::string& text) {
    try {
        parse_varied_key(text);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

// The numbers at evenly spaced fractions of the only range of a text, from 0 to 1.
std::vector<std::string> numbers_in(const std::string& text, int count) {
    const KeyValues varied = parse_varied_key(text);
    const auto& range = std::get<NumberRange>(varied.values.front());
    std::vector<std::string> numbers;
    for (int k = 0; k < count; ++k) {
        numbers.push_back(to_toml(number_at(varied, range, static_cast<double>(k) / (count - 1))));
    }
    return numbers;
}

TEST(VariedKeys, EveryValueIsChecked) {
    EXPECT_EQ(fault_of("foam.lloyd=0,1,2"), "");
    EXPECT_EQ(fault_of("loop.amplitude=0.1..0.4"), "");
    EXPECT_EQ(fault_of("albedo.colors=[\"#112233\"],[\"#445566\", \"#778899\"]"), "");
    EXPECT_EQ(fault_of("foam.lloyd=0,-1"),
              "'foam.lloyd=0,-1': foam.lloyd = -1: must be an integer from 0 to 1000");
    EXPECT_THAT(fault_of("foam.loyd=1"), HasSubstr("'foam.loyd' is not a key; did you mean"));
    EXPECT_THAT(fault_of("loop.amplitude=0.1..40"), HasSubstr("loop.amplitude = 40: must be"));
    EXPECT_THAT(fault_of("foam.lloyd=0..3:3"), HasSubstr("foam.lloyd = 1.5: must be"));
    EXPECT_THAT(fault_of("loop.amplitude=0.4..0.1"), HasSubstr("first number must be the smaller"));
    EXPECT_THAT(fault_of("preset.description=a,b"), HasSubstr("does not change pictures"));
    EXPECT_THAT(fault_of("output.exr_level=1,2"), HasSubstr("does not change pictures"));
    EXPECT_THAT(fault_of("event.kind=shear"), HasSubstr("is not a key"));
    EXPECT_THAT(fault_of("foam.lloyd"), HasSubstr("must be KEY=VALUES"));
    EXPECT_NE(fault_of("foam.seed=0..9223372036854775807"), "");
}

// foam.area_ratio allows 0 and the numbers from 1 to 100.
TEST(VariedKeys, ARangeMustHaveNoGaps) {
    EXPECT_EQ(fault_of("foam.area_ratio=1..10"), "");
    EXPECT_THAT(fault_of("foam.area_ratio=0..10"), HasSubstr("must be"));
}

TEST(VariedKeys, AListInAPresetIsCheckedWhenItIsRead) {
    const std::string message = test::rejection_of([] {
        parse_preset("[preset]\ndescription = \"d\"\nvary = [\"foam.lloyd=x\"]\n", "p", "p.toml");
    });
    EXPECT_THAT(message, HasSubstr("p.toml:3: key 'preset.vary' = [\"foam.lloyd=x\"]: "));
    EXPECT_THAT(message, HasSubstr("foam.lloyd = \"x\": must be an integer from 0 to 1000"));
    EXPECT_EQ(message.find('\n'), std::string::npos);
    const std::string twice = test::rejection_of([] {
        parse_preset("[preset]\nvary = [\"foam.lloyd=1\", \"foam.lloyd=2\"]\n", "p", "p.toml");
    });
    EXPECT_THAT(twice, HasSubstr("p.toml:2: key 'preset.vary'"));
    EXPECT_THAT(twice, HasSubstr("has foam.lloyd twice"));
}

// The range 0.1..0.4 needs steps of 0.01 to have at least 20 numbers.
TEST(VariedKeys, RealNumbersAreRounded) {
    EXPECT_THAT(numbers_in("loop.amplitude=0.1..0.4", 8),
                testing::ElementsAre("0.1", "0.14", "0.19", "0.23", "0.27", "0.31", "0.36", "0.4"));
    EXPECT_THAT(numbers_in("lit.elevation=20..45", 3), testing::ElementsAre("20", "33", "45"));
    EXPECT_THAT(numbers_in("thin_film.thickness=105..605", 3),
                testing::ElementsAre("110", "360", "605"));
}

// Fractions from 0 to 1/3 belong to 1, those up to 2/3 to 2, the others to 3.
TEST(VariedKeys, WholeNumbersAreEquallyLikely) {
    EXPECT_THAT(numbers_in("foam.lloyd=1..3", 7),
                testing::ElementsAre("1", "1", "2", "2", "3", "3", "3"));
    EXPECT_THAT(numbers_in("foam.bubbles=100..1000", 3),
                testing::ElementsAre("100", "550", "1000"));
}

TEST(VariedKeys, SeedsAreNotRounded) {
    EXPECT_THAT(numbers_in("foam.seed=1..999", 3), testing::ElementsAre("1", "500", "999"));
    EXPECT_THAT(numbers_in("foam.seed=3..1001", 4),
                testing::ElementsAre("3", "336", "669", "1001"));
    EXPECT_THAT(numbers_in("foam.seed=0..9000000000000", 3),
                testing::ElementsAre("0", "4500000000000", "9000000000000"));
}

TEST(VariedKeys, EveryShippedPresetHasAList) {
    for (const ShippedPreset& shipped : shipped_presets()) {
        const Preset preset = load_preset(std::string(shipped.name));
        EXPECT_GE(preset.vary.size(), 3U) << shipped.name;
    }
}

}  // namespace
}  // namespace foam::texgen
