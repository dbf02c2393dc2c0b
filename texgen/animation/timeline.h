// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/state_change.h"
#include "core/foam/foam.h"
#include "core/foam/random.h"
#include "texgen/events/all_events.h"
#include "texgen/preset/preset.h"
#include "texgen/raster/coords/raster_grid.h"

#include <optional>
#include <vector>

namespace foam::texgen {

/// Applies the events of a preset, frame by frame, and the renewal of a flow.
class Timeline {
  public:
    explicit Timeline(const Preset& preset);

    /// Begins the events that are due on the way to a frame: makes their new bubbles, small at
    /// first, and returns the change to impose during the step to that frame. In a flow new bubbles
    /// replace those that have vanished. Preconditions: the foam is in equilibrium; the function is
    /// called once for each frame, in increasing order. If an event finds no bubble to choose, if a
    /// position is outside of a patch, or if there is too little gas for a new bubble, nothing
    /// happens; this is no error.
    StateChange changes_to(int frame, Foam& foam);

    /// Sets the view of a patch, to which the positions of events refer. In the default view a foam
    /// unit is a pixel.
    void set_view(const View& view) { view_ = view; }

  private:
    // An event and its own random generator.
    struct Entry {
        Event event;
        Random random;
    };

    // The renewal of a flow. New bubbles begin at random points of the torus. Their gas comes from
    // the bubbles around them, mostly from large ones.
    struct Renewal {
        std::size_t bubbles = 0;  // number of bubbles to maintain
        int growth = 1;           // frames in which a new bubble grows to the mean area
        Random random;
    };

    void renew(int frame, Foam& foam);

    double t2_area_;
    Vec2 image_size_;  // pixels
    View view_;
    std::vector<Entry> entries_;
    std::optional<Renewal> renewal_;
    DrivenCourses courses_;
};

}  // namespace foam::texgen
