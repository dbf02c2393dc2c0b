// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/bake/bake.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// A file pattern with a folder that does not exist yet.
inline constexpr const char* kPattern = "deep/{preset}_{map}.####.png";

/// Bakes the first five frames and returns the contents of their files.
inline std::vector<Bytes> baked_files(const Preset& preset, int threads) {
    const BakeSummary summary = bake(preset, {.frames = {1, 2, 3, 4, 5}, .threads = threads}, {});
    std::vector<Bytes> contents;
    for (const std::filesystem::path& path : summary.files) {
        contents.push_back(read_file(path, kImageInput));
    }
    return contents;
}

}  // namespace foam::texgen
