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

/// A bubble whose target area follows a course while the foam goes through some frames.
struct DrivenCourse {
    FrameSpan frames;
    TargetCourse course;
    bool vanishes = false;  // at the last frame
};

/// The driven bubbles. The event that drives a bubble last replaces others.
using DrivenCourses = std::map<BubbleIdentity, DrivenCourse>;

/// Returns the point of the plane at a position in an image of this size (pixels). Positions are in
/// fractions of the image's width and height, from its lower left corner.
Vec2 point_in_view(const View& view, const Vec2& size, const std::array<double, 2>& position);

/// A foam in equilibrium on its way from one frame to the next, as an event finds and changes it.
struct EventStage {
    int frame = 0;  // the next one
    Foam& foam;
    Random& random;          // the event's own
    double t2_area = 0.0;    // foam units
    View view;               // of a patch
    Vec2 image_size;         // pixels
    StateChange& change;     // imposed on the way to the frame
    DrivenCourses& courses;  // imposed on the way to this and later frames

    /// Returns the point of the foam at a position in the image.
    Vec2 point_at(const std::array<double, 2>& position) const;
};

}  // namespace foam::texgen
