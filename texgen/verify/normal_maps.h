// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>
#include <vector>

namespace foam::texgen {

/// Returns the names of the maps whose pixels are normals.
std::vector<std::string_view> normal_map_names();

/// Returns true if the pixels of the map with this name are normals. `name` need not be the
/// name of a map.
bool is_normal_map(std::string_view name);

}  // namespace foam::texgen
