#pragma once

#include "texgen/chart/chart.h"
#include "texgen/stats/record.h"

#include <string>
#include <vector>

namespace foam::texgen {

struct NamedChart {
    std::string name;  // of its file, without an ending
    Chart chart;
};

/// The charts of a run:
///
///     mean_area      over time, with a line through the scaling state
///     second_moment  mu_2 over time with its mean in the scaling state, beside that of soap froths
///     sides          share of the bubbles of each number of sides, over time
///     pressures      mean pressure of the same, in film tensions over the root of the mean area
///     growth_rates   dA/dt by the number of sides, measured in two ways, beside von Neumann's law
///     seconds        time of a frame by the number of bubbles, beside the paper's Figure 5
///
/// Those over time leave out the frames of few bubbles, which tell little, as long as
/// there are others.
std::vector<NamedChart> charts(const RunRecord& run);

}  // namespace foam::texgen
