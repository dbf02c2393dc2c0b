#pragma once

namespace foam::texgen {

/// Returns the content of charts.gp, which draws the charts of the tables stats.csv and sides.csv.
const char* charts_script_text();

}  // namespace foam::texgen
