// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/dry_run.h"

#include "texgen/animation/progress_text.h"
#include "texgen/bake/bake_estimate.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cli/json_report.h"
#include "texgen/cli/report.h"
#include "texgen/cli/standard_output.h"
#include "texgen/image/memory.h"

#include <fmt/core.h>

#include <algorithm>
#include <string>

namespace foam::texgen {

namespace {

std::string duration_text(double seconds) {
    constexpr double kLong = 300.0;
    return seconds < kLong ? fmt::format("{:.{}f} s", seconds, seconds < 10.0 ? 1 : 0)
                           : long_duration(seconds);
}

/// Returns the estimate of all runs, or of the first run that fails.
BakeEstimate estimate_of(std::span<const ImageRun> runs, const ProgressOptions& progress) {
    BakeEstimate sum;
    for (const auto& [preset, options] : runs) {
        ProgressReporter reporter(progress);
        BakeEstimate one = estimate_bake(preset, options, reporter.callback());
        if (one.outcome.status != RunStatus::Complete || runs.size() == 1) {
            return one;
        }
        if (sum.files == 0) {
            sum.seconds = one.simulating;
            sum.outcome = one.outcome;
        }
        sum.files += one.files;
        sum.bytes += one.bytes;
        sum.memory = std::max(sum.memory, one.memory);
        sum.seconds += one.drawing;
    }
    return sum;
}

}  // namespace

ExitCode print_estimate(std::span<const ImageRun> runs,
                        bool json,
                        const ProgressOptions& progress) {
    const auto& [preset, options] = runs.front();
    const BakeEstimate estimate = estimate_of(runs, progress);
    const std::string frames = format_frame_range(options.frames);
    if (json) {
        Json report = json_report(estimate.outcome);
        report["preset"] = preset.name;
        report["frames"] = frames;
        report["files"] = estimate.files;
        report["bytes"] = estimate.bytes;
        report["memory"] = estimate.memory;
        report["seconds"] = estimate.seconds;
        print_json(report);
    }
    if (estimate.outcome.status != RunStatus::Complete) {
        return report_failure(estimate.outcome);
    }
    if (!json && progress.verbosity != Verbosity::Quiet) {
        const bool has_other_files =
            preset.output.sheets != SheetKind::None || !preset.output.scene.empty();
        print_stdout("frames: {} ({}){}\nfiles: {}, {}{}\nmemory: {}\ntime: about {}{}\n",
                     options.frames.size(),
                     frames,
                     runs.size() > 1 ? fmt::format(" in {} sizes", runs.size()) : "",
                     estimate.files,
                     amount_of_bytes(estimate.bytes),
                     has_other_files ? ", and sheets or scene files" : "",
                     amount_of_bytes(estimate.memory),
                     duration_text(estimate.seconds),
                     has_other_files ? " without sheets and scene files" : "");
    }
    return ExitCode::Success;
}

}  // namespace foam::texgen
