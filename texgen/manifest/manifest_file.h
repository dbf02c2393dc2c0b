// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace foam::texgen {

/// The name of the manifest in the folder of its images.
inline constexpr std::string_view kManifestName = "manifest.json";

/// Reads a manifest. `path` is the file or its folder. Throws InputError if the file is missing or
/// unreadable, or if it is not a manifest.
Manifest read_manifest(const std::filesystem::path& path);

/// Returns the only set of a preset, or, if `preset` is empty, the only set of the manifest. Throws
/// InputError if there is no such set or more than one; the message names `path` and lists all
/// sets.
const BakedSet& choose_set(const Manifest& manifest,
                           std::string_view preset,
                           const std::filesystem::path& path);

/// Returns the manifest of a folder, or an empty one if there is none. Throws InputError if
/// manifest.json in the folder is not a manifest.
Manifest manifest_in(const std::filesystem::path& folder);

/// Changes the manifest of a folder under a lock and writes it atomically. Creates the folder if it
/// does not exist. If the folder has no manifest, `change` receives an empty one. Throws InputError
/// if manifest.json is not a manifest, and OutputError if it cannot be written.
void update_manifest(const std::filesystem::path& folder,
                     const std::function<void(Manifest&)>& change);

}  // namespace foam::texgen
