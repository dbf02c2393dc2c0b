// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"

namespace foam::texgen {

inline constexpr EventTraits kDriveEvent = {
    .name = "drive",
    .meaning =
        "the target area of bubbles follows a ramp (`scale`) and an oscillation (`amplitude`, "
        "`period`, `phase`)",
    .takes_bubbles = true,
    .takes_position = true,
    .takes_count = true};

/// Selects whether all bubbles of an event oscillate with the phase DriveOptions::phase, or each
/// bubble with the sum of this phase and a random phase.
enum class Phases { Same, Random };

struct DriveOptions {
    double scale = 1.0;      // target area at the last frame divided by the area at the start,
                             // both without the oscillation
    double amplitude = 0.0;  // amplitude of the oscillation, as a fraction of the target area
    double period = 24.0;    // period of the oscillation, in frames
    double phase = 0.0;      // phase of the oscillation at its start, in cycles
    Phases phases = Phases::Same;
};

Keys<DriveOptions> drive_keys();

/// Rejects an event with an invalid choice of bubbles (check_choice). An event that chooses no
/// bubbles drives all bubbles.
void check_drive(const EventCheck& check, const DriveOptions& options);

/// Before the step to the first frame of the event, chooses bubbles and schedules their target
/// areas: a ramp times an oscillation (E9). If bubbles that the event should choose do not exist,
/// adds their number to context.missing. Does nothing at later frames.
void advance_drive(const EventBase& event, const DriveOptions& options, EventContext& context);

}  // namespace foam::texgen
