// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/manifest/file_lock.h"
#include "texgen/manifest/manifest.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <string_view>

namespace foam::texgen {

/// The file name of a manifest. The function manifest_folder (bake_recorder.h) returns its folder.
inline constexpr std::string_view kManifestName = "manifest.json";

/// Returns the path of a manifest. `path` is the manifest file or its folder; an empty path is the
/// working folder.
std::filesystem::path manifest_path(const std::filesystem::path& path);

/// Reads a manifest. `path` is the manifest file or its folder. Throws InputError if the file is
/// missing or unreadable, or if it is not a manifest.
Manifest read_manifest(const std::filesystem::path& path);

/// Returns the manifest of a folder, or an empty manifest if the folder has none. Throws InputError
/// if manifest.json in the folder is unreadable or not a manifest, and OutputError if the system
/// cannot tell whether the file exists.
Manifest manifest_in(const std::filesystem::path& folder);

/// Reads the manifest of a folder, calls change(manifest), and writes the changed manifest
/// atomically. All of this is done under a lock, so that programs do not overwrite each other's
/// changes. Creates the folder if it does not exist. If the folder has no manifest, `change`
/// receives an empty one. Throws InputError if manifest.json is unreadable or not a manifest, and
/// OutputError if it cannot be written or its lock is not free within the time `patience`.
void update_manifest(const std::filesystem::path& folder,
                     const std::function<void(Manifest&)>& change,
                     std::chrono::milliseconds patience = FileLock::kMaxWait);

}  // namespace foam::texgen
