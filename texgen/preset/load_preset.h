// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns true for the path of a file, which ends with ".toml" or contains a '/', and false for
/// the name of a shipped preset.
bool is_preset_path(std::string_view name_or_path);

/// Loads the preset in the file with the given path, or the shipped preset with the given name
/// (is_preset_path). A preset may extend another preset:
///
///     extends = "sea_foam"    # or the path of a file, relative to the folder of this file
///
/// The preset then inherits all values that it does not set. It inherits the events if it has no
/// events of its own.
///
/// Throws PresetError in these cases:
/// - A preset is invalid.
/// - A file is missing or unreadable.
/// - The file name without its extension is not a plain name (is_plain_name).
/// - Presets extend each other in a circle.
Preset load_preset(const std::string& name_or_path);

/// A preset, and the assignments of its own document, without the assignment to `extends` and
/// without the assignments of extended presets. Relative paths of files in the assignments are
/// relative to the working folder, not to the folder of the preset.
struct LoadedPreset {
    Preset preset;
    std::vector<Assignment> assignments;
};

/// Loads a preset as load_preset does. Reads its document only once, so that the preset and the
/// assignments agree even if the file changes meanwhile.
LoadedPreset load_with_assignments(const std::string& name_or_path);

}  // namespace foam::texgen
