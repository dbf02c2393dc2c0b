// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

/// The result of measure_run.
struct MeasureSummary {
    RunOutcome outcome;
    RunRecord run;  // if a frame failed, only the frames before it
};

/// Simulates the same frames as a bake of the preset, and measures them instead of drawing them.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
