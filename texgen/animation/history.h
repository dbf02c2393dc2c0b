#pragma once

#include "core/foam/foam.h"
#include "texgen/maps/foam_record.h"

namespace foam::texgen {

/// Keeps the record of a foam while it goes from frame to frame.
class History {
  public:
    /// Of a foam at time 0.
    explicit History(const Foam& foam);

    /// Takes the foam's events as those on the way to a frame from the one before it, and clears
    /// them.
    void take_events(Foam& foam, int frame);

    /// As if none had been.
    void forget_events() { record_.events.clear(); }

    /// Adds to the frames of all events: where frames are counted anew, as in the cycles of a loop.
    void renumber(int frames);

    /// Takes the foam's pressures as those that scale all others.
    void take_pressures(const Foam& foam);

    const FoamRecord& record() const { return record_; }

  private:
    void carry_events(const Domain& domain);

    FoamRecord record_;
    double time_ = 0.0;  // of the frame before
    Domain domain_;
};

}  // namespace foam::texgen
