#pragma once

#include "texgen/bake/bake.h"
#include "texgen/stats/record.h"

namespace foam::texgen {

struct MeasureSummary {
    RunOutcome outcome;  // the record ends before a frame that failed
    RunRecord run;
};

/// Takes the frames of a preset as a bake does, and measures instead of drawing them.
MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress);

}  // namespace foam::texgen
