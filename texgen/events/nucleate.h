// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"
#include "texgen/events/new_bubble.h"

namespace foam::texgen {

inline constexpr EventTraits kNucleateEvent = {.name = "nucleate",
                                               .meaning =
                                                   "`count` new bubbles of a given `area` appear "
                                                   "on junctions or films, evenly over the frames",
                                               .takes_position = true,
                                               .takes_count = true,
                                               .creates_bubbles = true};

struct NucleateOptions {
    NucleationSite on = NucleationSite::Junction;
    double area = 0.5;  // target area, square foam units
    int growth = 1;     // number of frames in which a new bubble grows to its area
};

Keys<NucleateOptions> nucleate_keys();

/// Rejects an event whose `area` is not above the T2 area, and an event that has a position but
/// creates more than one bubble.
void check_nucleate(const EventCheck& check, const NucleateOptions& options);

/// Creates the bubbles that are to appear before the step to the frame `context.frame`, and
/// schedules their growth to options.area. Adds the number of bubbles that cannot be created to
/// context.missing.
void advance_nucleate(const EventBase& event,
                      const NucleateOptions& options,
                      EventContext& context);

}  // namespace foam::texgen
