#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

namespace foam::texgen {

inline constexpr EventTraits kDriveEvent = {
    .name = "drive",
    .meaning =
        "the area of bubbles follows a ramp (`scale`) and a swing (`amplitude`, `period`, "
        "`phase`)",
    .takes_bubbles = true,
    .takes_position = true,
    .takes_count = true};

/// The start of the swings of several bubbles.
enum class Phases { Same, Random };

struct DriveOptions {
    double scale = 1.0;      // factor on the area, reached at the last frame
    double amplitude = 0.0;  // fraction of the area
    double period = 24.0;    // frames
    double phase = 0.0;      // turns
    Phases phases = Phases::Same;
};

Keys<DriveOptions> drive_keys();
void check_drive(const EventCheck& check, const DriveOptions& options);

/// Drives the areas of bubbles along a ramp and a swing (E9).
void advance_drive(const EventBase& event, const DriveOptions& options, EventStage& stage);

}  // namespace foam::texgen
