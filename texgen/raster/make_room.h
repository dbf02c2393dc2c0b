#pragma once

#include <cstddef>
#include <vector>

namespace foam::texgen {

/// At least `count` values, for arrays that are used again and again and only grow.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t count) {
    if (values.size() < count) {
        values.resize(2 * count);
    }
}

}  // namespace foam::texgen
