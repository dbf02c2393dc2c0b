// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/dynamics/cycle_drive.h"
#include "core/dynamics/step.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Returns the options of the cycles of a breathe, shear or boil loop.
CycleOptions cycle_options_of(const Preset& preset);

/// Returns the number of cycles after which half of the boils with so many bubbles had closed when
/// tests/bench/boil_table measured them (NOTES.md of this folder). For more than 2,000 bubbles,
/// returns the number for 2,000.
int usual_cycles(int bubbles);

/// Returns the options of the time steps of a preset, with a new linear system, which the steps
/// share. `threads` has the same meaning as in parallel_for.
StepOptions step_options_of(const Preset& preset, int threads);

}  // namespace foam::texgen
