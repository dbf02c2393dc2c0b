// SPDX-License-Identifier: Apache-2.0

#include "core/files/file_io.h"
#include "tests/fuzz/fuzz_target.h"
#include "texgen/cache/cache_files.h"

namespace foam::fuzz {

void fuzz_cache_info(std::string_view input) {
    const auto info =
        unless_rejected<InputError>([&] { return texgen::parse_info(input, "cache.json"); });
    require(!info || !info->frames.empty(), "a cache has a frame");
}

}  // namespace foam::fuzz
