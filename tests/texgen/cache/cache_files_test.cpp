// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache_files.h"

#include "tests/texgen/small_preset.h"
#include "tests/texgen/temporary_folder.h"
#include "texgen/cache/cache.h"
#include "texgen/image/file_io.h"
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

}  // namespace
}  // namespace foam::texgen
