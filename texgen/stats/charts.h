// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/record.h"

#include <filesystem>
#include <string>
#include <vector>

namespace foam::texgen {

/// The outcome of drawing charts. NoGnuplot means that gnuplot is not installed.
enum class ChartStatus { Drawn, NoGnuplot, GnuplotFailed };

/// Returns a gnuplot script that draws charts of a run's tables (csv.h) into the folder of the
/// tables. README.md explains which frames the charts show, when charts over the logarithm of time
/// are omitted, and what the scaling state is. The reference to "the paper" is in
/// core/EQUATIONS.md. The charts are:
///
///     mean_area      mean bubble area over time, with a line fitted to the scaling state
///     second_moment  second moment mu_2 of the number of sides over log time, the mean of mu_2 in
///                    the scaling state, and the value measured in soap froths
///     sides          for each number of sides from 3 to 10, the fraction of bubbles that have this
///                    number, over log time
///     pressures      for each number of sides from 3 to 10, the mean pressure of the bubbles that
///                    have this number, in units of film tension / sqrt(mean area), over log
///                    time; frames in which these bubbles are less than 1 % of all are omitted
///     growth_rates   mean dA/dt against the number of sides, measured from areas and from
///                    pressures, and von Neumann's law
///     stress         shear stress and normal stress difference, both in units of film tension /
///                    sqrt(mean area), over strain; a line whose slope is the shear modulus of the
///                    first frame, and a line at the largest shear stress; only if the frames have
///                    different strains
///     seconds        wall time per frame against the number of bubbles, and the times in Figure 5
///                    of the paper
std::string charts_script(const RunRecord& run);

/// Runs gnuplot on a script, with the folder of the script as working directory. Throws OutputError
/// if the folder does not exist, or if gnuplot is installed but cannot be started.
ChartStatus draw_charts(const std::filesystem::path& script);

/// Returns the paths of all charts that the script may write into a folder.
std::vector<std::filesystem::path> chart_paths(const std::filesystem::path& folder);

}  // namespace foam::texgen
