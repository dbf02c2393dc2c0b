// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/baked_file.h"

#include "core/files/file_io.h"
#include "texgen/image/format.h"
#include "texgen/image/pixel_hash.h"
#include "texgen/manifest/existing_frames.h"

#include <fmt/core.h>

namespace foam::texgen {

DecodedFile read_baked(const ManifestFile& file,
                       const std::filesystem::path& folder,
                       std::vector<std::string>& problems) {
    try {
        auto decoded = std::make_shared<const Picture>(read_picture(folder / file.path));
        if (pixel_hash(*decoded) == file.pixels) {
            return decoded;
        }
        problems.push_back(fmt::format(
            "{}: the pixels differ from the baked pixels (their hash differs from the hash "
            "in the manifest)",
            file.path));
    } catch (const InputError& error) {
        problems.emplace_back(error.what());
    }
    return nullptr;
}

bool is_unchanged_vector_file(const ManifestFile& file,
                              const std::filesystem::path& folder,
                              std::vector<std::string>& problems) {
    try {
        if (file_hash(folder / file.path) == file.pixels) {
            return true;
        }
        problems.push_back(fmt::format(
            "{}: the content differs from the baked content (its hash differs from the hash in the "
            "manifest)",
            file.path));
    } catch (const InputError& error) {
        problems.emplace_back(error.what());
    }
    return false;
}

}  // namespace foam::texgen
