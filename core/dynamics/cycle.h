#pragma once

#include "core/dynamics/step.h"

#include <cstdint>
#include <map>
#include <vector>

namespace foam {

/// What is done to a foam over and over (E9).
struct CycleOptions {
    int steps = 48;       // of a cycle
    double breath = 0.0;  // every target area swings by this part of itself, in a phase of its own
    double strain = 0.0;  // the shear of a torus swings by this
    std::uint64_t seed = 1;  // of the phases
};

/// A foam in equilibrium is a function of who touches whom, of its target areas and of its torus.
/// Where these go round in a cycle, it comes back to where it was, once the T1s and T2s of the
/// first cycles are through. No gas diffuses meanwhile. As a whole it is held where it was at the
/// start.
class Cycle {
  public:
    /// Target areas swing around those that the foam has.
    Cycle(const Foam& foam, const CycleOptions& options);

    /// From the state that a cycle began with, or from anywhere near, to place `place` of it, from
    /// 0, its start, on; and so on, round and round. Place k comes from place k - 1. As for any
    /// step, the foam is left between the two where the summary is not converged.
    StepSummary step_to(int place, Foam& foam, double time, const StepOptions& options) const;

  private:
    struct Swing {
        BubbleIdentity bubble = 0;
        double target_area = 0.0;
        double phase = 0.0;  // in turns
    };

    StateChange change_to(int place, const Domain& domain) const;
    void hold(Foam& foam) const;

    CycleOptions options_;
    double shear_;  // of the torus, at the start
    std::vector<Swing> swings_;
    std::map<BubbleIdentity, Vec2> centres_;  // of the bubbles of the foam
};

/// How far apart two states of a foam are: the largest distance of a junction of a bubble from the
/// nearest that the bubble has in the other, in diameters of a circle of the mean bubble area.
/// Infinite where a bubble has other sides or is not in both.
double closing_error(const Foam& one, const Foam& other);

}  // namespace foam
