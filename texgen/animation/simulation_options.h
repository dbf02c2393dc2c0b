// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle_drive.h"
#include "core/dynamics/step.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Returns the options of the cycles of a breathe, shear or boil loop.
CycleOptions cycle_options_of(const Preset& preset);

/// Returns about how many cycles a boil takes to close: the median that tests/bench/boil_table has
/// measured (NOTES.md of this folder). The table has a few numbers of bubbles. The result is the
/// median of the smallest one that is at least `bubbles`, or of 2,000 if all are smaller.
int usual_cycles(int bubbles);

/// Returns the options of the time steps of a preset, with a new linear system, which the steps
/// share. `threads` has the same meaning as in parallel_for.
StepOptions step_options_of(const Preset& preset, int threads);

}  // namespace foam::texgen
