// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/state_change.h"
#include "core/dynamics/target_area_schedule.h"
#include "core/foam/foam.h"
#include "core/foam/random.h"
#include "texgen/events/event_base.h"
#include "texgen/raster/coords/raster_grid.h"

#include <array>
#include <map>

namespace foam::texgen {

/// The schedule of the target area of a driven bubble over some frames.
struct DrivenSchedule {
    FrameSpan frames;
    TargetAreaSchedule schedule;
    bool vanishes = false;  // true if the bubble vanishes at the last frame
};

/// The schedules of all driven bubbles. If a later event drives the same bubble, the schedule of
/// the later event replaces the earlier schedule.
using DrivenSchedules = std::map<BubbleIdentity, DrivenSchedule>;

/// Returns the point of the plane, in foam units, at a position in an image. `size` is the size of
/// the image in pixels. The position is in fractions of the image's width and height, from the
/// lower left corner of the image.
Vec2 point_in_view(const View& view, const Vec2& size, const std::array<double, 2>& position);

/// The data that an event receives before each step that leads to one of its frames
/// (EventKind::advance). The step has not begun. The foam is in equilibrium, except for bubbles
/// that other events have just created. The event adds changes to impose during this step and later
/// ones. It may also change the foam directly.
struct EventContext {
    int frame = 0;  // the frame at the end of the step
    Foam& foam;
    Random& random;              // a generator that only this event uses
    double t2_area = 0.0;        // square foam units
    View view;                   // view of the images of a patch; unused on a torus
    Vec2 image_size;             // pixels
    StateChange& change;         // changes to impose during this step
    DrivenSchedules& schedules;  // target areas to impose during this step and later ones
    int missing = 0;  // number of bubbles that the event should choose but that do not exist, or
                      // number of new bubbles that it could not create

    /// Returns the point of the foam, in foam units, at a position in the image (point_in_view). An
    /// image of a torus shows exactly the torus.
    Vec2 point_at(const std::array<double, 2>& position) const;
};

}  // namespace foam::texgen
