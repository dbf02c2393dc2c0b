// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/conditions.h"

#include "texgen/preset/load_preset.h"
#include "texgen/preset/preset_io.h"
#include "texgen/preset/preset_keys.h"
#include "texgen/preset/shipped_presets.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

// Returns what unused_keys returns after the arguments of --set, for a preset of defaults.
std::vector<std::string> unused(const std::vector<std::string>& arguments) {
    std::vector<Assignment> assignments;
    assignments.reserve(arguments.size());
    for (const std::string& argument : arguments) {
        assignments.push_back(read_set_argument(argument));
    }
    Preset preset;
    assign(preset, assignments);
    return unused_keys(preset, assignments);
}

using Lines = std::vector<std::string>;

TEST(UnusedKeys, AreThoseThatAnotherKeySwitchesOff) {
    EXPECT_EQ(unused({"relief.profile=wet", "relief.angle=30"}),
              Lines{"relief.angle has no effect with relief.profile = \"wet\""});
    EXPECT_EQ(unused({"relief.angle=30", "relief.angle=40", "relief.profile=wet"}),
              Lines{"relief.angle has no effect with relief.profile = \"wet\""});
    EXPECT_EQ(unused({"lit.windows=0", "lit.window_size=9"}),
              Lines{"lit.window_size has no effect with lit.windows = 0"});
    EXPECT_EQ(unused({"albedo.shade=0", "albedo.shade_width=1"}),
              Lines{"albedo.shade_width has no effect with albedo.shade = 0.0"});
    EXPECT_EQ(unused({"foam.outline=disc"}),
              Lines{"foam.outline has no effect with foam.domain = \"torus\""});
    EXPECT_EQ(unused({"relief.angle=30", "lit.windows=2", "lit.window_size=9"}), Lines{});
}

TEST(UnusedKeys, NoShippedPresetSetsOne) {
    for (const ShippedPreset& shipped : shipped_presets()) {
        const LoadedPreset loaded = load_with_assignments(std::string(shipped.name));
        EXPECT_EQ(unused_keys(loaded.preset, loaded.assignments), Lines{}) << shipped.name;
    }
}

TEST(Conditions, NameExistingKeysAndAllowedValues) {
    for (const Key<Preset>& key : preset_keys()) {
        for (const std::optional<Condition>& condition : {key.condition, key.use}) {
            if (!condition) {
                continue;
            }
            const Key<Preset>* const other = find_key(condition->key);
            ASSERT_NE(other, nullptr) << key.path;
            for (const std::string& value : condition->values) {
                Preset preset;
                EXPECT_TRUE(other->read(read_value(value), preset)) << key.path;
                EXPECT_NE(is_met(*condition, preset), condition->excludes) << key.path;
            }
        }
    }
}

TEST(Conditions, AreDescribed) {
    EXPECT_EQ(describe_conditions(*find_key("foam.bubbles")), "");
    EXPECT_EQ(describe_conditions(*find_key("foam.outline")),
              "    only with foam.domain = \"patch\"\n");
    EXPECT_EQ(describe_conditions(*find_key("relief.width")),
              "    no effect unless relief.profile = \"ridge\" or \"wet\"\n");
    EXPECT_EQ(describe_conditions(*find_key("lit.window_size")),
              "    no effect with lit.windows = 0\n");
}

}  // namespace
}  // namespace foam::texgen
