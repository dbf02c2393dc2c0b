// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_context.h"

namespace foam::texgen {

inline constexpr EventTraits kShearEvent = {
    .name = "shear",
    .meaning =
        "the whole foam is sheared along x by a `strain`; its images tile again when the upper "
        "border has moved by a whole width"};

struct ShearOptions {
    double strain = 1.0;  // total shear strain over all frames
};

Keys<ShearOptions> shear_keys();

/// Rejects an event in a patch, which cannot be sheared.
void check_shear(const EventCheck& check, const ShearOptions& options);

/// Returns the strain by which an event has sheared the foam at a frame: the sum of the strains
/// that advance_shear has added up to this frame.
double strain_at(int frame, const EventBase& event, const ShearOptions& options);

/// Adds the strain, divided by the number of frames of the event, to context.change. The timeline
/// calls this function once for each frame of the event.
void advance_shear(const EventBase& event, const ShearOptions& options, EventContext& context);

}  // namespace foam::texgen
