#pragma once

#include "texgen/cli/exit_code.h"

#include <filesystem>
#include <span>

namespace foam::texgen {

/// One line a file, on stdout.
void print_files(std::span<const std::filesystem::path> files);

/// Says on stderr whose foam found no equilibrium; the code to leave with.
ExitCode report_no_equilibrium(int frame);

}  // namespace foam::texgen
