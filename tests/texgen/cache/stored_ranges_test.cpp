// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/stored_ranges.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/cache/small_simulation.h"
#include "texgen/bake/fitted_ranges.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {
namespace {

const std::vector<int> kFrames = {1, 2, 3};

// A preset with automatic ranges, and the same preset with the range that was "fitted" to height.
struct Ranges {
    Ranges() { fitted.maps.height.full.value = 0.315; }

    StoredRanges in(const std::filesystem::path& folder) const { return {preset, kFrames, folder}; }

    Preset preset = all_maps_of_a_foam();
    Preset fitted = preset;
};

TEST(StoredRanges, AreLoadedAsTheyWereSaved) {
    const TemporaryFolder folder;
    const Ranges ranges;
    ASSERT_TRUE(has_automatic_ranges(ranges.preset));
    ranges.in(folder.path()).save(ranges.fitted);
    EXPECT_EQ(folder.files().size(), maps_with_automatic_ranges(ranges.preset).size());
    Preset loaded = ranges.preset;
    EXPECT_TRUE(ranges.in(folder.path()).load(loaded));
    EXPECT_EQ(loaded.maps.height.full.value, 0.315);
    EXPECT_TRUE(loaded.maps.height.full.is_automatic);
}

TEST(StoredRanges, BelongToAFoamItsFramesAndTheLookOfItsMaps) {
    const TemporaryFolder folder;
    const Ranges ranges;
    ranges.in(folder.path()).save(ranges.fitted);
    const auto is_stored = [&](const std::function<void(Preset&)>& change) {
        Preset changed = ranges.preset;
        change(changed);
        return StoredRanges(changed, kFrames, folder.path()).load(changed);
    };
    EXPECT_TRUE(is_stored([](Preset&) {}));
    EXPECT_TRUE(is_stored([](Preset& preset) { preset.image.maps = {"height"}; }));
    EXPECT_FALSE(is_stored([](Preset& preset) { preset.seeding.seed += 1; }));
    EXPECT_FALSE(is_stored([](Preset& preset) { preset.maps.relief.width *= 2.0; }));
    EXPECT_TRUE(is_stored([](Preset& preset) { preset.maps.lit.light.elevation += 5.0; }));
    EXPECT_FALSE(is_stored([](Preset& preset) {  // ranges may be in pixels
        preset.image.width *= 2;
        preset.image.height *= 2;
    }));
    Preset preset = ranges.preset;
    EXPECT_FALSE(StoredRanges(preset, {1, 2}, folder.path()).load(preset));
}

TEST(StoredRanges, AreNotLoadedFromADamagedFile) {
    const TemporaryFolder folder;
    const Ranges ranges;
    const StoredRanges stored = ranges.in(folder.path());
    for (const std::string_view text :
         {"",
          "{}",
          R"({"format":"foamtex-range","version":1,"map":"height","full":-1})",
          R"({"format":"foamtex-range","version":1,"map":"height","full":1e300})",
          R"({"format":"foamtex-range","version":1,"map":"area","full":1})"}) {
        stored.save(ranges.fitted);
        for (const std::string& name : folder.files()) {
            if (name.starts_with("range.height.")) {
                write_file(folder.path() / name, std::as_bytes(std::span(text)));
            }
        }
        Preset loaded = ranges.preset;
        EXPECT_FALSE(stored.load(loaded)) << text;
        EXPECT_EQ(loaded.maps.height.full, ranges.preset.maps.height.full) << text;
    }
}

TEST(StoredRanges, AreNotSavedIfTheFolderCannotBeWritten) {
    const Ranges ranges;
    EXPECT_NO_THROW(ranges.in("/dev/null/foam").save(ranges.fitted));
}

}  // namespace
}  // namespace foam::texgen
