#pragma once

#include "core/dynamics/step.h"

#include <cstdint>
#include <map>
#include <vector>

namespace foam {

/// A periodic change of a foam (E9).
struct CycleOptions {
    int steps = 48;          // per cycle
    double breath = 0.0;     // amplitude of each target area, relative, in a phase of its own
    double strain = 0.0;     // amplitude of the shear of a torus
    std::uint64_t seed = 1;  // of the phases
};

/// A foam in equilibrium is a function of its topology, its target areas and its domain. If these
/// are periodic, it returns to its state after each cycle, once the T1s and T2s of the first cycles
/// have happened. No gas diffuses meanwhile. The foam as a whole is held where it was at the start.
class Cycle {
  public:
    /// Target areas oscillate around those of the foam.
    Cycle(const Foam& foam, const CycleOptions& options);

    /// Steps from position `place` - 1 of the cycle, or from a state near it, to position `place`;
    /// 0 is the start of a cycle. If the summary is not converged, the foam is left between the
    /// two, as after any step.
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
    double shear_;  // of the domain, at the start
    std::vector<Swing> swings_;
    std::map<BubbleIdentity, Vec2> centres_;  // of the bubbles of the foam
};

/// Returns the distance of two states of a foam: the largest distance of a junction of a bubble
/// from the nearest junction of the same bubble in the other state, in diameters of a circle of the
/// mean bubble area. Infinite if a bubble has another number of sides or is not in both.
double closing_error(const Foam& one, const Foam& other);

}  // namespace foam
