// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

/// The result of measure_run.
struct MeasureSummary {
    RunOutcome outcome;
    RunRecord run;  // ends before a frame that failed
};

/// Simulates the frames of a preset as a bake does, and measures them instead of drawing them.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
