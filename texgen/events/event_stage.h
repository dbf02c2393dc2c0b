// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/state_change.h"
#include "core/dynamics/target_course.h"
#include "core/foam/foam.h"
#include "core/foam/random.h"
#include "texgen/events/event_base.h"
#include "texgen/raster/coords/raster_grid.h"

#include <array>
#include <map>

namespace foam::texgen {

/// The course of the target area of a driven bubble over some frames.
struct DrivenCourse {
    FrameSpan frames;
    TargetCourse course;
    bool vanishes = false;  // true if the bubble vanishes at the last frame
};

/// The courses of all driven bubbles. A later event that drives the same bubble replaces its
/// course.
using DrivenCourses = std::map<BubbleIdentity, DrivenCourse>;

/// Returns the point of the plane at a position in an image. `size` is the size of the image in
/// pixels. Positions are fractions of the image's width and height, from its lower left corner.
Vec2 point_in_view(const View& view, const Vec2& size, const std::array<double, 2>& position);

/// The arguments of the effect of an event: the foam in equilibrium before the step to a frame, and
/// the changes to impose during that step and later ones. An event may also change the foam
/// directly.
struct EventStage {
    int frame = 0;  // the frame that the step leads to
    Foam& foam;
    Random& random;          // a generator that only this event uses
    double t2_area = 0.0;    // foam units
    View view;               // of a patch
    Vec2 image_size;         // pixels
    StateChange& change;     // imposed during the step to this frame
    DrivenCourses& courses;  // imposed during the steps to this and later frames

    /// Returns the point of the foam at a position in the image.
    Vec2 point_at(const std::array<double, 2>& position) const;
};

}  // namespace foam::texgen
