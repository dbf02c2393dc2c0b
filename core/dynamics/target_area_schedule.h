// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam {

/// The target area of a driven bubble as a function of time: a linear ramp times an oscillation
/// (E9).
struct TargetAreaSchedule {
    double from = 1.0;          // area at the start without the oscillation, square foam units
    double to = 1.0;            // area at the end without the oscillation, square foam units
    double amplitude = 0.0;     // relative amplitude of the oscillation; below 1
    double oscillations = 0.0;  // number of oscillations from start to end
    double phase = 0.0;         // phase at the start, in turns
};

/// Returns the target area at `passed`, the fraction of the time that has passed, from 0 to 1. With
/// t = `passed`, the target area is
/// (from + (to - from) t) (1 + amplitude sin(2 pi (oscillations t + phase))).
double target_at(const TargetAreaSchedule& schedule, double passed);

}  // namespace foam
