#include "texgen/stats/measure_run.h"

#include <chrono>

namespace foam::texgen {

namespace {

using Clock = std::chrono::steady_clock;

BakeProgress progress_of(const RunRecord& run, int total, Clock::time_point begin) {
    const FrameRecord& last = run.frames.back();
    return {.frame = last.frame,
            .done = static_cast<int>(run.frames.size()),
            .total = total,
            .bubbles = last.foam.bubbles,
            .area_error = last.effort.area_error,
            .angle_error = last.effort.angle_error,
            .seconds = std::chrono::duration<double>(Clock::now() - begin).count()};
}

}  // namespace

MeasureSummary measure_run(const Preset& preset,
                           const BakeOptions& options,
                           const ProgressCallback& on_progress) {
    const Clock::time_point begin = Clock::now();
    const int total = static_cast<int>(options.frames.size());
    Recorder recorder(preset);
    Simulation simulation(preset, options.threads);
    const auto measure = [&](const SimulatedFrame& shown) {
        recorder.record(shown.frame, shown.effort);
        if (on_progress) {
            on_progress(progress_of(recorder.run(), total, begin));
        }
    };
    const RunOutcome outcome =
        simulate_frames(simulation, options.frames, NextFrames::LeftOut, measure);
    return {outcome, recorder.run()};
}

}  // namespace foam::texgen
