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

/// Carries out the events of a preset, frame by frame, and the renewal of a flow.
class Timeline {
  public:
    explicit Timeline(const Preset& preset);

    /// Begins the events that are due on the way to a frame: makes their new bubbles, small at
    /// first, and returns the change to impose during the step to that frame. In a flow new bubbles
    /// replace those that have vanished. Preconditions: the foam is in equilibrium; frames come in
    /// order, each once. It is no error if a choice finds no bubble, if a position is outside of a
    /// patch, or if a new bubble finds too little gas around it; then nothing happens.
    StateChange changes_to(int frame, Foam& foam);

    /// Sets the view of a patch. Positions of events are fractions of it. By default a foam unit is
    /// a pixel.
    void set_view(const View& view) { view_ = view; }

  private:
    // An event with a random generator of its own.
    struct Entry {
        Event event;
        Random random;
    };

    // The renewal of a flow: new bubbles begin at random points of the torus. They take the gas of
    // the bubbles around them, so large bubbles give most.
    struct Renewal {
        std::size_t bubbles = 0;  // number of bubbles to maintain
        int growth = 1;           // frames that new bubbles take to reach the mean area
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
