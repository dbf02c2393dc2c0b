#pragma once

#include "texgen/stats/charts.h"
#include "texgen/stats/record.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// The name of the script beside the tables.
inline constexpr const char* kChartsScriptName = "charts.gp";

struct StatisticsFiles {
    std::vector<std::filesystem::path> paths;  // the tables, the script, and the charts if drawn
    ChartStatus charts = ChartStatus::Drawn;
};

/// Writes the tables (csv.h) and the script of the charts (charts.h) into a folder, which is made
/// as needed, and draws the charts if gnuplot is installed. A table appears under its name only
/// when it is complete; charts of an earlier run are removed. Throws OutputError.
StatisticsFiles write_statistics(const RunRecord& run, const std::filesystem::path& folder);

}  // namespace foam::texgen
