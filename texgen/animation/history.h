// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/foam.h"
#include "texgen/maps/foam_record.h"

#include <vector>

namespace foam::texgen {

/// Keeps the record of a foam up to date while the foam advances from frame to frame.
class History {
  public:
    /// Starts the record of a foam. The bubbles of this foam count as born at its present time,
    /// which is 0 if it was just seeded. `smoothing` is FramesOptions::smoothing.
    explicit History(const Foam& foam, double smoothing = 0.0);

    /// Moves the foam's topology events, which happened during the step to the given frame, into
    /// the record. Also records when bubbles were born and when their neighbors last changed. Drops
    /// events whose frame is at least kRecordedFrames frames before the given frame. `strain` is
    /// the total strain of the foam (Simulation::strain); the positions of earlier events are
    /// sheared with the foam. Domain::shear is not enough for this: it is the shear only up to a
    /// multiple of the width of the torus.
    void record_events(Foam& foam, int frame, double strain = 0.0);

    /// Removes all events from the record.
    void forget_events() { record_.events.clear(); }

    /// Adds `frames` to the frame numbers of all recorded events. This is needed between the cycles
    /// of a loop, because frame numbers start again in each cycle.
    void renumber(int frames);

    /// Records the foam's pressures, which define the pressure scale of all frames
    /// (FoamRecord::first_pressures).
    void record_pressures(const Foam& foam);

    /// Sets FoamRecord::first_pressures to pressures that were recorded earlier.
    void set_pressures(std::vector<double> first_pressures);

    /// Updates the averages of values (RecentAverages) with the present values of the foam. Call it
    /// once per frame. Does nothing if `smoothing` is 0.
    void average_values(const Foam& foam);

    /// Replaces the averages by the averages after infinitely many cycles of a loop, which do not
    /// depend on what happened before the loop. `start` is the record before the last cycle, which
    /// had the given number of frames. Precondition: the foam has the same bubbles at the start and
    /// at the end of this cycle.
    void close_averages(const FoamRecord& start, int frames);

    const FoamRecord& record() const { return record_; }

  private:
    // Moves the positions of recorded events with a foam that has been sheared by the given strain.
    void shear_recorded_events(double strain);

    FoamRecord record_;
    std::vector<BubbleIdentity> newborn_;  // bubbles born in the step to the present frame
    double smoothing_;
    double time_ = 0.0;    // foam time of the previous frame
    double strain_ = 0.0;  // total strain of the previous frame
};

}  // namespace foam::texgen
