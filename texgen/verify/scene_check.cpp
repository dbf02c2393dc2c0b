// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/scene_check.h"

#include "core/files/file_io.h"
#include "texgen/manifest/existing_frames.h"

#include <fmt/core.h>

namespace foam::texgen {

std::vector<std::string> scene_problems(const BakedSet& set, const std::filesystem::path& folder) {
    std::vector<std::string> problems;
    for (const ManifestScene& scene : set.scenes) {
        try {
            if (file_hash(folder / scene.path) != scene.hash) {
                problems.push_back(
                    fmt::format("{}: the content differs from the written content (its hash "
                                "differs from the hash in the manifest)",
                                scene.path));
            }
        } catch (const InputError& error) {
            problems.emplace_back(error.what());
        }
    }
    return problems;
}

}  // namespace foam::texgen
