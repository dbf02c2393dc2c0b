// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/report.h"

#include <fmt/core.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace foam::texgen {

void print_files(std::span<const std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        fmt::print("{}\n", file.string());
    }
}

void note_missing_charts(const StatisticsFiles& statistics) {
    if (statistics.charts == ChartStatus::Drawn) {
        return;
    }
    const bool missing = statistics.charts == ChartStatus::NoGnuplot;
    fmt::print(stderr,
               "foamtex: note: charts are missing, because gnuplot {}; to draw them, run in '{}': "
               "gnuplot {}\n",
               missing ? "is not installed" : "failed",
               statistics.paths.front().parent_path().string(),
               kChartsScriptName);
}

ExitCode report_failure(const RunOutcome& outcome) {
    if (outcome.status == RunStatus::OpenLoop) {
        const double error = *outcome.closing_error;
        const std::string apart =
            std::isfinite(error)
                ? fmt::format("are {:.2g} mean diameters away from those at its start", error)
                : "have different neighbors than at its start";
        fmt::print(stderr,
                   "foamtex: the loop does not close: bubbles at the end of its last cycle {}; "
                   "use a smaller loop.amplitude or more loop.cycles\n",
                   apart);
    } else {
        fmt::print(stderr,
                   "foamtex: frame {}: the foam did not reach equilibrium\n",
                   outcome.failed_frame);
    }
    return ExitCode::NoEquilibrium;
}

}  // namespace foam::texgen
