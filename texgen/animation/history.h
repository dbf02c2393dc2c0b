// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/maps/foam_record.h"

namespace foam::texgen {

/// Keeps the record of a foam up to date while the foam advances from frame to frame.
class History {
  public:
    /// Begins with a foam at time 0.
    explicit History(const Foam& foam);

    /// Records the foam's events as events of the step to the given frame, and clears them in the
    /// foam. Also updates births and changes of bubbles.
    void take_events(Foam& foam, int frame);

    /// Removes all events.
    void forget_events() { record_.events.clear(); }

    /// Adds `frames` to the frame numbers of all events. Used between cycles of a loop, because
    /// frame numbers start again in each cycle.
    void renumber(int frames);

    /// Records the foam's pressures, which scale the pressures of all frames
    /// (FoamRecord::first_pressures).
    void take_pressures(const Foam& foam);

    const FoamRecord& record() const { return record_; }

  private:
    // Moves the recorded positions along with the shear of the domain.
    void carry_events(const Domain& domain);

    FoamRecord record_;
    double time_ = 0.0;  // foam time of the previous frame
    Domain domain_;      // domain of the positions of the recorded events
};

}  // namespace foam::texgen
