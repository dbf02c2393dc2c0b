#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

struct MeasureSummary {
    BakeStatus status = BakeStatus::Complete;
    int failed_frame = 0;  // whose foam found no equilibrium; the record ends before it
    RunRecord run;
};

/// Simulates the frames of a preset as a bake does, and measures instead of drawing them.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
