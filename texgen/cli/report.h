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

/// If no charts were drawn, prints the reason and the command that draws them on stderr.
void note_missing_charts(const StatisticsFiles& statistics);

/// Prints on stderr why a run failed, and returns the exit code for this failure. Precondition: the
/// run failed.
ExitCode report_failure(const RunOutcome& outcome);

}  // namespace foam::texgen
