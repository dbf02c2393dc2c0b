#pragma once

#include "texgen/chart/chart.h"

#include <string>

namespace foam::texgen {

/// The chart as an SVG document: a framed plot with ticks on nice numbers, the legend on its right.
/// Without any point the axes go from 0 to 1, or from 1 to 10 on a logarithm.
std::string to_svg(const Chart& chart);

}  // namespace foam::texgen
