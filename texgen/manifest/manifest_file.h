#pragma once

#include "texgen/manifest/manifest.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace foam::texgen {

/// The name of the manifest in the folder of its images.
inline constexpr std::string_view kManifestName = "manifest.json";

/// Takes the file itself, or the folder that it lies in. Throws InputError where it is missing,
/// unreadable, or no manifest.
Manifest read_manifest(const std::filesystem::path& path);

/// The one set of a manifest, or that of a preset where there are several. Throws InputError that
/// lists the presets there are, in the name of `path`.
const BakedSet& choose_set(const Manifest& manifest,
                           std::string_view preset,
                           const std::filesystem::path& path);

/// That of a folder; an empty one where there is none. Throws InputError where it is no manifest.
Manifest manifest_in(const std::filesystem::path& folder);

/// Changes the manifest of a folder, which is made as needed; without a manifest it starts from an
/// empty one. One program at a time, all or nothing. Throws InputError where there is another file
/// of that name, OutputError where it cannot be written.
void update_manifest(const std::filesystem::path& folder,
                     const std::function<void(Manifest&)>& change);

}  // namespace foam::texgen
