// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache_files.h"

#include "core/files/file_io.h"
#include "tests/support/temporary_folder.h"
#include "tests/texgen/small_preset.h"
#include "texgen/cache/cache.h"
#include "texgen/maps/map.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foam::texgen {
namespace {

TEST(CacheFiles, RejectsAFolderThatIsNoCache) {
    const TemporaryFolder folder;
    EXPECT_FALSE(is_cache(folder.path()));
    EXPECT_THROW(Cache(folder.path()), InputError);
    const std::string text = "{\"format\": \"foamtex-cache\", \"version\": 2}";
    write_file(folder.path() / "cache.json", std::as_bytes(std::span(text)));
    EXPECT_THROW(Cache(folder.path()), InputError);
}

// The name becomes a part of the names of images.
TEST(CacheFiles, TheNameOfThePresetMustBePlain) {
    const TemporaryFolder folder;
    CacheInfo info;
    info.preset.name = "../../evil";
    info.frames = {1};
    write_info(info, folder.path());
    try {
        read_info(folder.path());
        ADD_FAILURE() << "the name was accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("preset = \"../../evil\": must be a plain name"),
                  std::string::npos)
            << error.what();
    }
}

}  // namespace
}  // namespace foam::texgen
