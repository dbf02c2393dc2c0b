#include "texgen/cli/report.h"

#include <fmt/core.h>

#include <cstdio>

namespace foam::texgen {

void print_files(std::span<const std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        fmt::print("{}\n", file.string());
    }
}

ExitCode report_failure(const RunOutcome& outcome) {
    if (outcome.status == RunStatus::OpenLoop) {
        fmt::print(stderr,
                   "foamtex: the loop does not close: the ends of its last cycle are {:.2g} mean "
                   "bubble diameters apart; take a smaller loop.amplitude, or more loop.cycles\n",
                   *outcome.closing_error);
    } else {
        fmt::print(
            stderr, "foamtex: frame {}: the foam found no equilibrium\n", outcome.failed_frame);
    }
    return ExitCode::NoEquilibrium;
}

}  // namespace foam::texgen
