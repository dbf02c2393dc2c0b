#pragma once

#include "core/geometry/vec2.h"
#include "core/network/ids.h"

#include <cstdint>
#include <vector>

namespace foam {

/// The number under which a bubble is known from its birth to its end; never used again.
using BubbleIdentity = std::uint32_t;

enum class TopologyEventKind {
    T1,     // films swapped neighbours; in a patch also: one tore, or a hole closed
    T2,     // a bubble vanished
    Birth,  // a new bubble
};

/// Where and when it changed who touches whom.
struct TopologyEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    double time = 0.0;                      // of the foam, at the start of the substep
    Vec2 place{0.0, 0.0};                   // then; anywhere in the plane
    std::vector<BubbleIdentity> bubbles{};  // whose neighbours changed; one that vanished too

    friend bool operator==(const TopologyEvent&, const TopologyEvent&) = default;
};

}  // namespace foam
