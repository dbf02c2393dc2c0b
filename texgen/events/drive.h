// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

namespace foam::texgen {

inline constexpr EventTraits kDriveEvent = {
    .name = "drive",
    .meaning =
        "the target area of bubbles follows a ramp (`scale`) and an oscillation (`amplitude`, "
        "`period`, `phase`)",
    .takes_bubbles = true,
    .takes_position = true,
    .takes_count = true};

/// Selects whether several bubbles oscillate with the same phase or with random phases.
enum class Phases { Same, Random };

struct DriveOptions {
    double scale = 1.0;      // factor on the area, reached at the last frame
    double amplitude = 0.0;  // of the oscillation, as a fraction of the area
    double period = 24.0;    // of the oscillation, in frames
    double phase = 0.0;      // of the oscillation at its start, in cycles
    Phases phases = Phases::Same;
};

Keys<DriveOptions> drive_keys();
void check_drive(const EventCheck& check, const DriveOptions& options);

/// Makes the target areas of the chosen bubbles follow a ramp and an oscillation (E9).
void advance_drive(const EventBase& event, const DriveOptions& options, EventStage& stage);

}  // namespace foam::texgen
