// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

/// The result of measure_run. If a step finds no equilibrium or the loop does not close, `outcome`
/// says so (RunOutcome::status), and no exception is thrown.
struct MeasureSummary {
    RunOutcome outcome;
    RunRecord run;  // if the run ended early, only the frames before its end
};

/// Measures the frames that a bake with the same options would draw, without drawing them. The
/// frames come from options.source or, if it is empty, from a simulation of the preset. Of the
/// options, only `frames`, `source` and `threads` are used. `on_progress` receives the phases of
/// the source, and then the phase Frames. Throws the exceptions of the source.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
