// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle_drive.h"
#include "core/dynamics/step.h"
#include "core/dynamics/unrest.h"

#include <cstddef>
#include <map>

namespace foam {

/// A periodic sequence of foams, for looping animations. The equilibrium of a foam follows from its
/// topology, its target areas and its domain. In a Cycle, the target areas and the domain change
/// periodically. In the first cycles, T1s and T2s may keep the foam from returning to its state at
/// the start of the cycle. After some cycles, the foam usually is in the same state at the end of
/// each cycle. Bubbles may also boil, that is, vanish and be born again in every cycle (boiling.h).
/// Some regions may then not return to the same state; `calm` weakens the periodic change there. No
/// gas diffuses. After each step, a torus as a whole, or each raft of a patch, is moved back to the
/// place where it was when the Cycle was constructed.
class Cycle {
  public:
    /// Starts a cycle with a random drive (random_drive). A position of the cycle is a number of
    /// steps since its start (step_to). If the drive changes target areas, the foam is not at
    /// position 0 until step_to has been called with the position 0.
    Cycle(const Foam& foam, const CycleOptions& options);

    /// Starts a cycle with the given drive, for example the drive of an earlier Cycle. Of the
    /// options, only the number of steps and the strain are used.
    Cycle(const Foam& foam, const CycleOptions& options, CycleDrive drive);

    /// Returns the drive, which changes in `calm` and when a boiling bubble vanishes.
    const CycleDrive& drive() const { return drive_; }

    /// Advances the foam from position `position` - 1 of the cycle, or from a state near it, to
    /// position `position`. Positions count the steps from the start of the first cycle, which is
    /// position 0, and may exceed CycleOptions::steps. `time` is the foam time that the step takes.
    /// If the summary is not converged, the foam is left between the two positions.
    StepSummary step_to(int position, Foam& foam, double time, const StepOptions& options);

    /// Returns true if every boiling bubble vanished between the same bubbles the last two times,
    /// so that it will be born between them again. The loop of a boil is closed if, after each of
    /// two cycles in a row, this function returns true and closing_error is small. One cycle is not
    /// enough: closing_error does not compare the flags of films that have flipped
    /// (Foam::t1_armed), and these flags may make the next cycle differ.
    bool repeats() const;

    /// Weakens the periodic change where it keeps the foam from being the same after each cycle.
    /// Bubbles whose neighbors keep changing from cycle to cycle oscillate less, and the boiling
    /// bubbles nearest to them grow to smaller areas. Does nothing if no bubbles boil. Call `calm`
    /// with the foam at the end of each cycle.
    void calm(const Foam& foam);

  private:
    double sine_at(int position, double phase) const;
    double strain_to(int position, const Domain& domain) const;
    void give_births(int position, Foam& foam, double first_area) const;
    StateChange change_to(int position,
                          const Domain& domain,
                          const TopologyThresholds& thresholds) const;
    Vec2 restore_positions(Foam& foam) const;
    void record_ends(const Foam& foam, std::size_t first_event, const Vec2& translation);
    BoilingBubble* nearest_with_reducible_rise(const Domain& domain,
                                               const std::map<BubbleIdentity, Vec2>& centers,
                                               const Vec2& point);

    CycleOptions options_;
    double shear_;  // shear of the domain at the start
    CycleDrive drive_;
    std::map<BubbleIdentity, Vec2> centers_;  // centers of bubbles that do not boil, at the start
    Unrest unrest_;
};

/// Returns the distance between two states of a foam. This is the largest distance from a junction
/// of a bubble in `one` to the nearest junction of the same bubble in `other`. The unit is the
/// diameter of a circle of the mean target area. Returns infinity if a bubble is missing in one
/// state, or if the number of sides of a bubble differs between the states. Lone bubbles do not
/// count; the distance of states without other bubbles is 0.
double closing_error(const Foam& one, const Foam& other);

}  // namespace foam
