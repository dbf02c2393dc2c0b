// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation.h"

#include "texgen/variations/variation_labels.h"

#include <gtest/gtest.h>

#include <vector>

namespace foam::texgen {
namespace {

TEST(Variation, CombinesTheValuesOfSweeps) {
    const std::vector<Sweep> sweeps = {read_sweep("foam.lloyd=1,2"), read_seeds("5-7")};
    const std::vector<Variation> variations = variations_of(sweeps);
    ASSERT_EQ(variations.size(), 6U);
    EXPECT_EQ(label_text(variations.front()), "lloyd=1, seed=5");
    EXPECT_EQ(label_text(variations[1]), "lloyd=1, seed=6");
    EXPECT_EQ(label_text(variations.back()), "lloyd=2, seed=7");
    const std::vector<Preset> presets = presets_of(Preset(), variations);
    EXPECT_EQ(presets[3].seeding.lloyd_iterations, 2);
    EXPECT_EQ(presets[3].seeding.seed, 5U);
}

TEST(Variation, AValueThatAKeyDoesNotAllowIsRejected) {
    const std::vector<Sweep> sweeps = {read_sweep("foam.bubbles=50,2")};
    EXPECT_THROW(presets_of(Preset(), variations_of(sweeps)), PresetError);
}

TEST(Variation, AKeyHasOneSweep) {
    const std::vector<Sweep> sweeps = {read_seeds("1-2"), read_sweep("foam.seed=3")};
    EXPECT_THROW(variations_of(sweeps), PresetError);
}

TEST(Variation, TooManyCombinationsAreRejected) {
    const std::vector<Sweep> sweeps = {read_seeds("1-21"), read_sweep("foam.lloyd=0..19:20")};
    EXPECT_THROW(variations_of(sweeps), PresetError);
}

}  // namespace
}  // namespace foam::texgen
