// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The outcome of drawing charts: success, or the reason of failure.
enum class ChartStatus { Drawn, NoGnuplot, GnuplotFailed };

/// Returns a script for gnuplot that draws charts of a run's tables (csv.h) into their folder.
/// Charts over the logarithm of time are left out if a run has too few frames. The charts are:
///
///     mean_area      over time, with a line fitted to the scaling state
///     second_moment  mu_2 over log time, its mean in the scaling state, and that of soap froths
///     sides          share of the bubbles with each number of sides, over log time
///     pressures      mean pressure of these bubbles, in film tensions over the square root of the
///                    mean area, over log time
///     growth_rates   dA/dt by the number of sides, measured in two ways, and von Neumann's law
///     seconds        time of a frame by the number of bubbles, and the paper's Figure 5
std::string charts_script(const RunRecord& run);

/// Runs gnuplot on a script, in the folder of the script.
ChartStatus draw_charts(const std::filesystem::path& script);

/// Returns the paths of all files that the script may draw into a folder.
std::vector<std::filesystem::path> chart_paths(const std::filesystem::path& folder);

}  // namespace foam::texgen
