#pragma once

#include "texgen/stats/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// Why there are charts of a run, or why not.
enum class ChartStatus { Drawn, NoGnuplot, GnuplotFailed };

/// Returns a script for gnuplot that draws the charts of a run's tables (csv.h) beside them. A run
/// of few frames has no charts over the logarithm of time:
///
///     mean_area      over time, with a line through the scaling state
///     second_moment  mu_2 over log time with its mean in the scaling state, beside soap froths
///     sides          share of the bubbles of each number of sides, over log time
///     pressures      mean pressure of the same, in film tensions over the root of the mean area
///     growth_rates   dA/dt by the number of sides, measured in two ways, beside von Neumann's law
///     seconds        time of a frame by the number of bubbles, beside the paper's Figure 5
std::string charts_script(const RunRecord& run);

/// Runs gnuplot with a script in its folder.
ChartStatus draw_charts(const std::filesystem::path& script);

/// Returns the files that the script can draw into a folder.
std::vector<std::filesystem::path> chart_paths(const std::filesystem::path& folder);

}  // namespace foam::texgen
