// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// Selects sets of images of a manifest. A set is selected if it agrees with all members that are
/// not empty.
struct SetChoice {
    std::string preset = {};
    std::optional<std::uint64_t> seed = {};
    std::optional<int> width = {};
    std::optional<int> height = {};
};

/// Returns a name of a set for messages, such as "lava (seed 6, 512 x 512)".
std::string name_of(const BakedSet& set);

/// Returns the sets that a choice selects, in the order of the manifest: the newest set is last.
std::vector<const BakedSet*> selected_sets(const Manifest& manifest, const SetChoice& choice);

/// Returns the newest set that a choice selects. Throws InputError if it selects no set; if the
/// manifest has any sets, the message lists them. `path` is the file or the folder of the manifest,
/// for the message.
const BakedSet& newest_set(const Manifest& manifest,
                           const SetChoice& choice,
                           const std::filesystem::path& path);

}  // namespace foam::texgen
