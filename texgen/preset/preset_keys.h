// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"
#include "texgen/preset/preset.h"

#include <span>
#include <string_view>

namespace foam::texgen {

/// Returns the keys of a preset, table by table. Help, completion, reading, writing and error
/// messages all use this list.
std::span<const Key<Preset>> preset_keys();

/// Returns the key that has a path such as "foam.seed", or nullptr if there is none.
const Key<Preset>* find_key(std::string_view path);

/// Returns true if any key belongs to the table.
bool is_table(std::string_view name);

}  // namespace foam::texgen
