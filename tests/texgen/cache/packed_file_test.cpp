// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/packed_file.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/cache/small_simulation.h"
#include "texgen/cache/cache.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>

namespace foam::texgen {
namespace {

TEST(PackedFile, AStateThatIsMissingDamagedOrForeignIsRejected) {
    const TemporaryFolder folder;
    simulate_into_cache(all_maps_of_a_foam(), {.frames = {1, 2}, .threads = 1}, folder.path(), {});
    EXPECT_EQ(error_of(folder.path(), 2), "");
    EXPECT_EQ(error_of(folder.path(), 7),
              "the cache '" + folder.path().string() +
                  "' has no state 7; only frames 1-2 can be drawn, and only after 'foamtex "
                  "simulate' has written their states");
    const std::filesystem::path path = folder.path() / "state.000002.foam";
    const std::string prefix = "cannot read '" + path.string() + "': ";
    const Bytes good = read_file(path, kImageInput);
    const auto error_with = [&](std::size_t place_of_byte) {
        Bytes bad = good;
        bad.at(place_of_byte) ^= std::byte{1};
        write_file(path, bad);
        return error_of(folder.path(), 2);
    };
    EXPECT_EQ(error_with(good.size() - 1),
              prefix + "the file is damaged: its checksum does not match");
    EXPECT_EQ(error_with(0), prefix + "not a foamtex file of kind 'state'");
    EXPECT_EQ(error_with(16), prefix + "file version 3 is not supported; must be 2");
    EXPECT_EQ(error_with(30), prefix + "the file belongs to a different simulation than its cache");
    write_file(path, std::span(good).first(20));
    EXPECT_EQ(error_of(folder.path(), 2), prefix + "not a foamtex file of kind 'state'");
}

}  // namespace
}  // namespace foam::texgen
