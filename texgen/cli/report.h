#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/cli/exit_code.h"
#include "texgen/stats/files.h"

#include <filesystem>
#include <span>

namespace foam::texgen {

/// One line a file, on stdout.
void print_files(std::span<const std::filesystem::path> files);

/// Tells on stderr why there are no charts beside the tables, if there are none.
void note_missing_charts(const StatisticsFiles& statistics);

/// Says on stderr which frame failed and why; the code to leave with.
ExitCode report_failure(const RunOutcome& outcome);

}  // namespace foam::texgen
