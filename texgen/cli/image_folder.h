// SPDX-License-Identifier: Apache-2.0

#pragma once

// The folders of images that `flipbook`, `preview` and `verify` read.

#include "texgen/manifest/set_choice.h"

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The options that select a set of images of a folder, as given on the command line.
struct SetArguments {
    std::string preset;               // empty if not given
    std::optional<std::string> size;  // "W" or "WxH"
    std::optional<std::string> seed;
};

/// Adds --preset, --size and --seed. The arguments must outlive the parsing.
void add_set_options(CLI::App& command, SetArguments& arguments);

/// Returns the choice that the options make. A size W selects sets of width W and any height.
/// Throws std::invalid_argument for a size that is not W or WxH, or a seed that is not a whole
/// number of at least 0.
SetChoice choice_of(const SetArguments& arguments);

/// Returns true if a path is the name of a shipped preset, and no file or folder has this name.
bool is_preset_name(const std::string& path);

/// Reads the manifest of a folder; `path` is the folder or the manifest. Throws InputError if the
/// manifest is missing, unreadable or malformed. If the path is a cache of simulated states or the
/// name of a preset, the message says which command draws its images.
Manifest read_image_manifest(const std::filesystem::path& path);

/// Returns the result of newest_set for the same arguments, and throws its exceptions. If the
/// choice selects several sets and `quiet` is false, prints a note on stderr that lists them.
const BakedSet& chosen_set(const Manifest& manifest,
                           const SetChoice& choice,
                           const std::filesystem::path& path,
                           bool quiet);

}  // namespace foam::texgen
