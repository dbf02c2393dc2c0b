// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns all keys of a preset except the keys of events. The keys of a table are consecutive.
/// Help, completion, reading, writing and error messages all use this list.
std::span<const Key<Preset>> preset_keys();

/// Returns the key with the given path, such as "foam.seed", or nullptr if there is none.
const Key<Preset>* find_key(std::string_view path);

/// Returns the files that the values of a preset name, such as the picture of foam.density, in the
/// order of the keys.
std::vector<NamedFile> files_of(const Preset& preset);

/// Returns a text that changes if the content of any file of files_of(preset) changes; empty if
/// there is no such file.
std::string file_hashes(const Preset& preset);

/// Replaces the paths of files that assignments name, such as the picture of foam.density, by
/// located(path). Paths in a preset are relative to the folder of its file.
void locate_files(std::span<Assignment> assignments,
                  const std::function<std::string(const std::string& path)>& located);

/// Returns the path that was probably meant by an unknown path. This is the path of a key with the
/// same name in another table. If there is no such key, the result is the most similar path.
/// Returns an empty view if no path is similar.
std::string_view nearest_key(std::string_view path);

/// Returns true if `name` is the name of a table that contains keys of a preset.
bool is_table(std::string_view name);

}  // namespace foam::texgen
