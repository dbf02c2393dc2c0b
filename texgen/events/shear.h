// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/events/event_check.h"
#include "texgen/events/event_stage.h"

namespace foam::texgen {

inline constexpr EventTraits kShearEvent = {
    .name = "shear",
    .meaning =
        "the whole foam is sheared along x by a `strain`; its images tile again when the shift is "
        "a whole width"};

struct ShearOptions {
    double strain = 1.0;  // total of all frames
};

Keys<ShearOptions> shear_keys();
void check_shear(const EventCheck& check, const ShearOptions& options);

/// Shears the whole torus by an equal part of the strain in each frame.
void advance_shear(const EventBase& event, const ShearOptions& options, EventStage& stage);

}  // namespace foam::texgen
