// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "core/network/ids.h"

#include <cstdint>
#include <vector>

namespace foam {

/// A number that identifies a bubble. Two bubbles never have the same number, with one exception: a
/// boiling bubble (core/dynamics/boiling.h) that is born again has the same number as before.
using BubbleIdentity = std::uint32_t;

/// The kinds of topology changes.
enum class TopologyEventKind {
    T1,     // bubbles swapped neighbors; in a patch also: a film tore or a hole closed
    T2,     // a bubble vanished
    Birth,  // a bubble was added (nucleation)
};

/// Returns "T1", "T2" or "birth".
constexpr const char* name_of(TopologyEventKind kind) {
    switch (kind) {
        case TopologyEventKind::T1:
            return "T1";
        case TopologyEventKind::T2:
            return "T2";
        case TopologyEventKind::Birth:
            break;
    }
    return "birth";
}

/// The record of one topology change.
struct TopologyEvent {
    TopologyEventKind kind = TopologyEventKind::T1;
    double time = 0.0;        // foam time at the start of the substep (core/dynamics/step.h)
    Vec2 position{0.0, 0.0};  // where the change happened; not wrapped into the fundamental cell
    // The bubbles whose neighbors changed, without the ghost. For T2 and Birth, the first is the
    // bubble that vanished or was added.
    std::vector<BubbleIdentity> bubbles{};

    friend bool operator==(const TopologyEvent&, const TopologyEvent&) = default;
};

}  // namespace foam
