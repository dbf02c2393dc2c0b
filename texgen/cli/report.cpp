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
               "foamtex: note: charts are drawn by gnuplot, which {}; in '{}', run: gnuplot {}\n",
               missing ? "is not installed" : "failed",
               statistics.paths.front().parent_path().string(),
               kChartsScriptName);
}

ExitCode report_failure(const RunOutcome& outcome) {
    if (outcome.status == RunStatus::OpenLoop) {
        const double error = *outcome.closing_error;
        const std::string apart = std::isfinite(error)
                                      ? fmt::format("lie {:.2g} mean diameters elsewhere", error)
                                      : "have other neighbors";
        fmt::print(
            stderr,
            "foamtex: the loop does not close: bubbles at the end of its last cycle {} than at "
            "its start; take a smaller loop.amplitude, or more loop.cycles\n",
            apart);
    } else {
        fmt::print(
            stderr, "foamtex: frame {}: the foam found no equilibrium\n", outcome.failed_frame);
    }
    return ExitCode::NoEquilibrium;
}

}  // namespace foam::texgen
