// SPDX-License-Identifier: Apache-2.0

#include "texgen/manifest/set_choice.h"

#include "core/files/file_io.h"
#include "tests/texgen/manifest/small_set.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foam::texgen {
namespace {

/// Returns two sets of the preset "a" with different sizes and seeds, and one of "b".
Manifest three_sets() {
    Manifest manifest{
        {small_set("a", {1}, {1}), small_set("b", {1}, {1}), small_set("a", {1}, {1})}};
    manifest.sets[2].width = 128;
    manifest.sets[2].seed = 13;
    return manifest;
}

std::string error_of(const Manifest& manifest, const SetChoice& choice) {
    try {
        newest_set(manifest, choice, "out");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(SetChoice, TakesTheNewestOfTheSelectedSets) {
    const Manifest manifest = three_sets();
    EXPECT_EQ(&newest_set(manifest, {}, "out"), &manifest.sets[2]);
    EXPECT_EQ(&newest_set(manifest, {.preset = "a"}, "out"), &manifest.sets[2]);
    EXPECT_EQ(&newest_set(manifest, {.preset = "b"}, "out"), &manifest.sets[1]);
    EXPECT_EQ(&newest_set(manifest, {.preset = "a", .width = 64}, "out"), &manifest.sets[0]);
    EXPECT_EQ(&newest_set(manifest, {.seed = 13}, "out"), &manifest.sets[2]);
    EXPECT_EQ(selected_sets(manifest, {.height = 32}).size(), 3U);
    EXPECT_EQ(selected_sets(manifest, {.seed = 12}),
              (std::vector{manifest.sets.data(), manifest.sets.data() + 1}));
}

TEST(SetChoice, AMissingSetIsAnErrorThatListsAllSets) {
    EXPECT_EQ(error_of({}, {}), "'out' lists no images");
    EXPECT_EQ(error_of(three_sets(), {.preset = "c", .seed = 1, .width = 2, .height = 3}),
              "'out' has no images of preset 'c', seed 1, width 2, height 3; it has images of: a "
              "(seed 12, 64 x 32), b (seed 12, 64 x 32), a (seed 13, 128 x 32)");
    Manifest manifest = three_sets();
    manifest.sets.resize(1);
    manifest.sets[0].preset = "sea_foam";
    EXPECT_EQ(error_of(manifest, {.preset = "sea_fom"}),
              "'out' has no images of preset 'sea_fom'; it has images of: sea_foam (seed 12, 64 x "
              "32); did you mean 'sea_foam'?");
    // The preset is right; only the seed is wrong.
    EXPECT_EQ(error_of(manifest, {.preset = "sea_foam", .seed = 1}),
              "'out' has no images of preset 'sea_foam', seed 1; it has images of: sea_foam (seed "
              "12, 64 x 32)");
}

}  // namespace
}  // namespace foam::texgen
