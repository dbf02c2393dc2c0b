// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cassert>
#include <cstdint>

namespace foam {

/// The zone of a node while a part of a graph is divided. Low and High are the two sides of the
/// separator. Nodes of the separator and nodes of other parts are in Outside.
enum class Zone : std::uint8_t { Outside, Low, High };

/// Returns High for Low, and Low for High. Precondition: the zone is not Outside.
constexpr Zone opposite(Zone zone) {
    assert(zone != Zone::Outside);
    return zone == Zone::Low ? Zone::High : Zone::Low;
}

}  // namespace foam
