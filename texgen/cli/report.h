#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/cli/exit_code.h"

#include <filesystem>
#include <span>

namespace foam::texgen {

/// One line a file, on stdout.
void print_files(std::span<const std::filesystem::path> files);

/// Says on stderr which frame failed and why; the code to leave with.
ExitCode report_failure(const RunOutcome& outcome);

}  // namespace foam::texgen
