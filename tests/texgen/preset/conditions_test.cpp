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
    EXPECT_EQ(unused({"albedo.color_mix=pick", "albedo.colormap=magma"}),
              Lines{"albedo.color_mix has no effect with albedo.colors = []"});
    EXPECT_EQ(unused({"albedo.colormap=magma", "albedo.colors=[\"#ff0000\"]"}),
              Lines{"albedo.colormap has no effect with albedo.colors = [\"#ff0000\"]"});
    EXPECT_EQ(unused({"loop.kind=drift", "loop.drift=[0, 1]", "frames.time_step=1"}),
              Lines{"frames.time_step has no effect with loop.kind = \"drift\""});
    EXPECT_EQ(unused({"loop.kind=breathe", "frames.step_growth=1.1"}),
              Lines{"frames.step_growth has no effect with loop.kind = \"breathe\""});
    EXPECT_EQ(unused({"relief.angle=30", "lit.windows=2", "lit.window_size=9"}), Lines{});
}

TEST(UnusedKeys, IncludeTheDiffusionConstantIfNoGasDiffuses) {
    EXPECT_EQ(
        unused({"loop.kind=breathe", "dynamics.kappa=2"}),
        Lines{"dynamics.kappa has no effect with loop.kind = \"breathe\" and frames.warm_up = "
              "0.0"});
    EXPECT_EQ(unused({"frames.time_step=0", "dynamics.kappa=2"}),
              Lines{"dynamics.kappa has no effect with frames.time_step = 0.0 and frames.warm_up = "
                    "0.0"});
    EXPECT_EQ(unused({"loop.kind=breathe", "frames.warm_up=9", "dynamics.kappa=2"}), Lines{});
    EXPECT_EQ(unused({"frames.time_step=1", "dynamics.kappa=2"}), Lines{});
    EXPECT_EQ(unused({"loop.kind=breathe", "dynamics.kappa=0"}), Lines{});
}

// exr_level depends on exr_compression, which depends on the suffix of the files.
TEST(UnusedKeys, IncludeThoseOfAnotherFileFormat) {
    EXPECT_EQ(unused({"output.pattern=a.####.png", "output.exr_level=9"}),
              Lines{"output.exr_level has no effect with output.pattern = \"a.####.png\""});
    EXPECT_EQ(unused({"output.pattern=a.####.exr", "output.png_compression=small"}),
              Lines{"output.png_compression has no effect with output.pattern = \"a.####.exr\""});
    EXPECT_EQ(unused({"output.pattern=a.exr", "output.exr_compression=piz", "output.exr_level=9"}),
              Lines{"output.exr_level has no effect with output.exr_compression = \"piz\""});
    EXPECT_EQ(unused({"output.pattern=a.####.exr", "output.exr_level=9"}), Lines{});
    EXPECT_EQ(unused({"output.pattern=a.####.EXR", "output.exr_level=9"}), Lines{});
}

TEST(UnusedKeys, IncludeTheBorderOfADrawingThatHasNone) {
    EXPECT_EQ(unused({"output.pattern=a.####.png", "vector.wrap=whole"}),
              Lines{"vector.wrap has no effect with output.pattern = \"a.####.png\""});
    EXPECT_EQ(unused({"output.pattern=a.####.svg", "vector.wrap=whole"}), Lines{});
    EXPECT_EQ(unused({"output.pattern=a.####.svg", "vector.wrap=whole", "foam.domain=patch"}),
              Lines{"vector.wrap has no effect with foam.domain = \"patch\""});
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
    EXPECT_EQ(describe_conditions(*find_key("output.exr_numbers")),
              "    no effect unless output.pattern = \"*.exr\"\n");
    EXPECT_EQ(describe_conditions(*find_key("albedo.color_mix")),
              "    no effect with albedo.colors = []\n");
    EXPECT_EQ(describe_conditions(*find_key("lit.window_size")),
              "    no effect with lit.windows = 0\n");
}

}  // namespace
}  // namespace foam::texgen
