// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam::texgen {

/// The content of charts.gp, the gnuplot script that draws charts of stats.csv and sides.csv.
extern const std::string_view kChartsScriptText;

}  // namespace foam::texgen
