// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

#include <array>

namespace foam::texgen {

inline constexpr EventTraits kForceEvent = {.name = "force",
                                            .meaning =
                                                "junctions around a position are pushed; the foam "
                                                "relaxes, and only swaps of neighbors remain",
                                            .takes_position = true};

struct ForceOptions {
    double radius = 2.0;                   // foam units
    std::array<double, 2> push{1.0, 0.0};  // total of all frames, foam units
};

Keys<ForceOptions> force_keys();
void check_force(const EventCheck& check, const ForceOptions& options);

/// Pushes the foam around a point by an equal part of the push in each frame. The point moves by
/// the same part.
void advance_force(const EventBase& event, const ForceOptions& options, EventStage& stage);

}  // namespace foam::texgen
