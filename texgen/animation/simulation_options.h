// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle_drive.h"
#include "core/dynamics/step.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Returns the options of the cycles of a breathe, shear or boil loop.
CycleOptions cycle_options_of(const Preset& preset);

/// Returns about how many cycles a boil takes to close: the median that tests/bench/boil_table has
/// measured (NOTES.md of this folder) for 100, 300, 500, 1,000 and 2,000 bubbles. The result is the
/// median for the smallest of these numbers that is at least `bubbles`, or for 2,000 if there is
/// none.
int usual_cycles(int bubbles);

/// Returns the options of the time steps of a preset, with a new linear system, which the steps
/// share. `threads` has the same meaning as in parallel_for.
StepOptions step_options_of(const Preset& preset, int threads);

}  // namespace foam::texgen
