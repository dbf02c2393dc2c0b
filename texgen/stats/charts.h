// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The outcome of drawing charts: success, or the reason for the failure.
enum class ChartStatus { Drawn, NoGnuplot, GnuplotFailed };

/// Returns a gnuplot script that draws charts of a run's tables (csv.h) into the folder of the
/// tables. Charts over the logarithm of time are omitted if a run has too few frames. The charts
/// are:
///
///     mean_area      over time, with a line fitted to the scaling state
///     second_moment  mu_2 over log time, its mean in the scaling state, and the value measured in
///                    soap froths
///     sides          share of the bubbles with each number of sides, over log time
///     pressures      mean pressure of these bubbles, in film tensions over the square root of the
///                    mean area, over log time
///     growth_rates   mean dA/dt against the number of sides, measured in two ways, and von
///                    Neumann's law
///     seconds        time per frame against the number of bubbles, and the paper's Figure 5
std::string charts_script(const RunRecord& run);

/// Runs gnuplot on a script, with the folder of the script as working directory.
ChartStatus draw_charts(const std::filesystem::path& script);

/// Returns the paths of all charts that the script may write into a folder.
std::vector<std::filesystem::path> chart_paths(const std::filesystem::path& folder);

}  // namespace foam::texgen
