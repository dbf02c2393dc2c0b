// SPDX-License-Identifier: Apache-2.0

#include "texgen/keys/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace foam::texgen {
namespace {

constexpr std::array<std::string_view, 3> kNames = {"sea_foam", "labyrinth", "coarsening"};

TEST(Nearest, FindsTheWordOfATypo) {
    EXPECT_EQ(nearest("sea_foma", kNames), "sea_foam");   // two replacements
    EXPECT_EQ(nearest("labrynth", kNames), "labyrinth");  // one left out, one replaced
    EXPECT_EQ(nearest("coarseningg", kNames), "coarsening");
}

TEST(Nearest, FindsNothingForUnrelatedWords) {
    EXPECT_EQ(nearest("beer", kNames), "");
    EXPECT_EQ(nearest("", kNames), "");
}

// Two replacements change any word of two letters into any other.
TEST(Nearest, AShortWordAllowsOnlyOneEdit) {
    constexpr std::array<std::string_view, 3> kShort = {"px", "wet", "none"};
    EXPECT_EQ(nearest("mm", kShort), "");
    EXPECT_EQ(nearest("yes", kShort), "");
    EXPECT_EQ(nearest("p", kShort), "");
    EXPECT_EQ(nearest("pc", kShort), "px");
    EXPECT_EQ(nearest("wett", kShort), "wet");
    EXPECT_EQ(nearest("nnoe", kShort), "none");
}

TEST(Nearest, FindsTheOnlyWordThatBeginsAlike) {
    constexpr std::array<std::string_view, 4> kCommands = {
        "bake", "flipbook", "presets", "preview"};
    EXPECT_EQ(nearest("fli", kCommands), "flipbook");
    EXPECT_EQ(nearest("fl", kCommands), "");
    EXPECT_EQ(nearest("pre", kCommands), "");
}

TEST(Nearest, TakesTheCloserOfTwo) {
    constexpr std::array<std::string_view, 2> kClose = {"image.size", "image.maps"};
    EXPECT_EQ(nearest("image.map", kClose), "image.maps");
}

TEST(Nearest, ASuggestionEndsAMessage) {
    EXPECT_EQ(did_you_mean("labrynth", kNames), "; did you mean 'labyrinth'?");
    EXPECT_EQ(did_you_mean("beer", kNames), "");
}

}  // namespace
}  // namespace foam::texgen
