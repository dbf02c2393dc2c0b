// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace foam {

/// Returns the index as a 32-bit number. Large tables store indices in this type. Precondition: the
/// index is below 2^32.
inline std::uint32_t narrow(std::size_t index) {
    assert(index <= std::numeric_limits<std::uint32_t>::max());
    return static_cast<std::uint32_t>(index);
}

}  // namespace foam
