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

/// Returns the sum of the strains by which the shear events of a preset have sheared the foam at a
/// state of the simulation. Precondition: the preset is valid (check_events does not throw).
double strain_of_events(const Preset& preset, int state);

/// Applies the events of a preset, frame by frame. In a flow (a loop of the kind "flow"), also
/// replaces bubbles that have vanished.
class Timeline {
  public:
    /// Precondition: the preset is valid (check_events does not throw).
    explicit Timeline(const Preset& preset);

    /// Begins the events that are due in the step to a frame and returns the change to impose
    /// during that step. New bubbles of events are added to the foam, small at first. In a flow,
    /// new bubbles replace the bubbles that have vanished. Bubbles that an event should choose, but
    /// that do not exist, are skipped without an error. New bubbles that would be outside of a
    /// patch, or for which there is too little gas, are also skipped.
    ///
    /// Preconditions: the foam is in equilibrium; the function is called once for each frame, in
    /// increasing order.
    StateChange changes_to(int frame, Foam& foam);

    /// Returns, for each event, the number of missing bubbles. A bubble is missing if the event
    /// should have chosen or created it by now, but it did not exist or could not be created.
    std::vector<int> missing_bubbles() const;

    /// Sets the view of a patch. The positions of events are fractions of this view. Until the
    /// first call, one foam unit is one pixel, and the origin is in the middle of the image.
    void set_view(const View& view) { view_ = view; }

  private:
    // An event and its own random number generator.
    struct Entry {
        Event event;
        Random random;
        int missing = 0;  // the number that missing_bubbles returns for this event
    };

    // The renewal of a flow: new bubbles appear at random points of the torus until there are as
    // many bubbles as at the first call of renew. The initial gas of a new bubble comes from its
    // neighbors. The gas for its growth comes from all bubbles that have no schedule
    // (DrivenSchedules). In both cases, bubbles lose gas in proportion to their target areas.
    struct Renewal {
        std::size_t bubbles = 0;  // number of bubbles to maintain; 0 before the first call of renew
        int growth = 1;           // number of frames in which a new bubble grows to the mean area
        Random random;
    };

    void renew(int frame, Foam& foam);

    double t2_area_;
    Vec2 image_size_;  // pixels
    View view_;
    std::vector<Entry> entries_;
    std::optional<Renewal> renewal_;
    DrivenSchedules schedules_;
};

}  // namespace foam::texgen
