// SPDX-License-Identifier: Apache-2.0

#include "texgen/variations/variation_labels.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

Variation with(const std::vector<std::string>& settings) {
    Variation variation;
    for (const std::string& setting : settings) {
        variation.assignments.push_back(read_set_argument(setting));
    }
    return variation;
}

TEST(VariationLabels, LeaveOutTablesUnlessTwoKeysHaveTheSameName) {
    EXPECT_EQ(label_text(with({"foam.lloyd=2", "foam.seed=7"})), "lloyd=2, seed=7");
    EXPECT_EQ(label_text(with({"relief.grain=0.1", "albedo.grain=0.2", "foam.seed=7"})),
              "relief.grain=0.1, albedo.grain=0.2, seed=7");
}

TEST(VariationLabels, ShowWordsWithoutQuotesAndColorsAsColors) {
    const auto labels = picture_labels(with({"albedo.colormap=magma",
                                             "albedo.film_color=\"#102030\"",
                                             "albedo.colors=[\"#ff0000\", \"#0000ff\"]",
                                             "loop.drift=[0, 1]"}));
    ASSERT_EQ(labels.size(), 4U);
    EXPECT_EQ(labels[0].text, "colormap=magma");
    EXPECT_TRUE(labels[0].colors.empty());
    EXPECT_EQ(labels[1].text, "film_color");
    EXPECT_EQ(labels[1].colors, (std::vector{Srgb8{0x10, 0x20, 0x30}}));
    EXPECT_EQ(labels[2].text, "colors");
    EXPECT_EQ(labels[2].colors, (std::vector{Srgb8{255, 0, 0}, Srgb8{0, 0, 255}}));
    EXPECT_EQ(labels[3].text, "drift=[0, 1]");
}

}  // namespace
}  // namespace foam::texgen
