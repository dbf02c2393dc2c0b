#pragma once

namespace foam::texgen {

/// The content of charts.gp, which draws the charts of the tables stats.csv and sides.csv.
extern const char* const kChartsScript;

}  // namespace foam::texgen
