// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace foam::texgen {

/// Returns at most `max_count` items of a list, evenly spaced. The first item is always included.
template <class Item>
std::vector<Item> spread(const std::vector<Item>& items, std::size_t max_count) {
    const std::size_t count = std::min(items.size(), max_count);
    std::vector<Item> chosen;
    for (std::size_t k = 0; k < count; ++k) {
        chosen.push_back(items[k * items.size() / count]);
    }
    return chosen;
}

}  // namespace foam::texgen
