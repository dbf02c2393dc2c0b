// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/cli/exit_code.h"
#include "texgen/stats/files.h"

#include <filesystem>
#include <span>

namespace foam::texgen {

/// Prints the paths of files on stdout, one per line.
void print_files(std::span<const std::filesystem::path> files);

/// Prints a note on stderr if no charts were drawn: the reason, and the command that draws them.
void note_missing_charts(const StatisticsFiles& statistics);

/// Prints on stderr why a run failed, and returns the exit code. Precondition: the run failed.
ExitCode report_failure(const RunOutcome& outcome);

}  // namespace foam::texgen
