// SPDX-License-Identifier: Apache-2.0

#include "texgen/verify/normal_maps.h"

#include "texgen/maps/all_maps.h"

#include <algorithm>

namespace foam::texgen {

std::vector<std::string_view> normal_map_names() {
    std::vector<std::string_view> names;
    for (const Map& map : all_maps()) {
        if (map.mixing == Mixing::Slopes) {
            names.push_back(map.name);
        }
    }
    return names;
}

bool is_normal_map(std::string_view name) {
    const std::vector<std::string_view> names = normal_map_names();
    return std::ranges::find(names, name) != names.end();
}

}  // namespace foam::texgen
