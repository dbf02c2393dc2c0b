// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string_view>

namespace foam::texgen {

/// Returns all keys of a preset except the keys of events. The keys of a table are consecutive.
/// Help, completion, reading, writing and error messages all use this list.
std::span<const Key<Preset>> preset_keys();

/// Returns the key with the given path, such as "foam.seed", or nullptr if there is none.
const Key<Preset>* find_key(std::string_view path);

/// Returns the path that was probably meant by an unknown path: the path of a key with the same
/// name in another table or, if there is none, the most similar path. Returns an empty view if no
/// path is similar.
std::string_view nearest_key(std::string_view path);

/// Returns true if `name` is the name of a table that contains keys of a preset.
bool is_table(std::string_view name);

}  // namespace foam::texgen
