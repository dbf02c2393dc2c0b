// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

/// The result of measure_run.
struct MeasureSummary {
    RunOutcome outcome;
    RunRecord run;  // if the run failed, only the frames before the failure
};

/// Takes the same frames as a bake of the preset from their source, by default a simulation of the
/// preset, and measures them instead of drawing them. Of the options, only `frames`, `source` and,
/// if there is no source, `threads` are used. `on_progress` is called after each frame. Throws the
/// exceptions of the source.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
