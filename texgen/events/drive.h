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

/// Selects whether several bubbles swing with the same phase or with random phases.
enum class Phases { Same, Random };

struct DriveOptions {
    double scale = 1.0;      // factor on the area, reached at the last frame
    double amplitude = 0.0;  // of the swing, as a fraction of the area
    double period = 24.0;    // of the swing, in frames
    double phase = 0.0;      // of the swing at the start, in turns
    Phases phases = Phases::Same;
};

Keys<DriveOptions> drive_keys();
void check_drive(const EventCheck& check, const DriveOptions& options);

/// Drives the areas of bubbles along a ramp and a swing (E9).
void advance_drive(const EventBase& event, const DriveOptions& options, EventStage& stage);

}  // namespace foam::texgen
