// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/stats/charts.h"
#include "texgen/stats/record.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// The file name of the gnuplot script, which is written into the folder of the tables.
inline constexpr const char* kChartsScriptName = "charts.gp";

/// The result of write_statistics.
struct StatisticsFiles {
    std::vector<std::filesystem::path> paths;  // the tables, the script, and the drawn charts
    ChartStatus charts = ChartStatus::Drawn;
};

/// Writes the tables (csv.h) and the script of the charts (charts.h) into a folder, and draws the
/// charts if gnuplot is installed. The folder is created if needed. Charts of an earlier run are
/// removed before new ones are drawn. If this run has no table of mazes (maze_csv returns an empty
/// text), the file maze.csv of an earlier run is removed. Tables and script are written atomically.
/// Throws OutputError if a table or the script cannot be written, or if a file of an earlier run
/// cannot be removed. Also throws the exceptions of draw_charts.
StatisticsFiles write_statistics(const RunRecord& run, const std::filesystem::path& folder);

}  // namespace foam::texgen
