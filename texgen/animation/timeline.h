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

    /// Carries out everything that is due on the way to a frame: makes new bubbles, small at first,
    /// in a foam that is in equilibrium, and returns the change to impose on that way. Frames must
    /// come in order, each once. Nothing happens for a choice that finds no bubble, a position
    /// outside of a patch, and a new bubble with too little gas around it. In a flow new bubbles
    /// replace those that have vanished.
    StateChange changes_to(int frame, Foam& foam);

    /// Sets the view of a patch, in fractions of which events have their positions. By default a
    /// foam unit is a pixel.
    void set_view(const View& view) { view_ = view; }

  private:
    // An event and the random numbers that are its own.
    struct Entry {
        Event event;
        Random random;
    };

    // The renewal of a flow: new bubbles begin at random points of the torus, so that large
    // bubbles, whose gas they take, give most.
    struct Renewal {
        std::size_t bubbles = 0;  // to keep up
        int growth = 1;           // frames that new ones take to the mean area
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
