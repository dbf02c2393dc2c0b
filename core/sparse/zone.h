// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace foam {

/// The side of a node in the part of a graph that is being divided. Nodes of the separator and of
/// other parts are Outside.
enum class Zone : std::uint8_t { Outside, Low, High };

/// Returns the other one of Low and High.
constexpr Zone opposite(Zone zone) {
    return zone == Zone::Low ? Zone::High : Zone::Low;
}

}  // namespace foam
