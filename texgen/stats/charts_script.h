// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string_view>

namespace foam::texgen {

/// Returns the content of charts.gp, the gnuplot script that draws charts of stats.csv,
/// sides.csv and stress.csv.
std::string_view charts_script_text();

}  // namespace foam::texgen
