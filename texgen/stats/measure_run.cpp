// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/measure_run.h"

#include "texgen/animation/progress_meter.h"

namespace foam::texgen {

MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress) {
    const FrameSource source =
        options.source ? options.source : simulation_of(preset, options.threads);
    ProgressMeter meter(Phase::Frames, static_cast<int>(options.frames.size()), on_progress);
    Recorder recorder(preset, options.threads);
    const auto measure = [&](const SimulatedFrame& shown) {
        recorder.record(shown.frame, shown.effort);
        meter.add(shown);
    };
    const RunOutcome outcome =
        source(options.frames, NextFrames::Omitted, measure, meter.for_source());
    return {outcome, recorder.run()};
}

}  // namespace foam::texgen
