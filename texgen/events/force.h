// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"

#include <array>

namespace foam::texgen {

inline constexpr EventTraits kForceEvent = {.name = "force",
                                            .meaning =
                                                "junctions around a position are pushed; then the "
                                                "foam relaxes, so that only swaps of neighbors "
                                                "remain",
                                            .takes_position = true};

struct ForceOptions {
    double radius = 2.0;                   // radius of the pushed region, foam units
    std::array<double, 2> push{1.0, 0.0};  // total displacement of the center, foam units
};

Keys<ForceOptions> force_keys();

/// Rejects an event without a position. On a torus, also rejects a radius above half of the shorter
/// side.
void check_force(const EventCheck& check, const ForceOptions& options);

/// Adds the push, divided by the number of frames of the event, to context.change. The push
/// displaces the junctions around a center. The center starts at the position `at` and moves along
/// with the push from frame to frame. The timeline calls this function once for each frame of the
/// event.
void advance_force(const EventBase& event, const ForceOptions& options, EventContext& context);

}  // namespace foam::texgen
