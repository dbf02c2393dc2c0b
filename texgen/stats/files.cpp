// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/files.h"

#include "core/files/file_io.h"
#include "texgen/stats/csv.h"

#include <fmt/core.h>

#include <span>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// Removes a file if it exists. Throws OutputError if it cannot be removed.
void remove_file(const std::filesystem::path& path) {
    std::error_code error;
    std::filesystem::remove(path, error);
    if (error) {
        throw OutputError(fmt::format("cannot remove '{}': {}", path.string(), error.message()));
    }
}

}  // namespace

StatisticsFiles write_statistics(const RunRecord& run, const std::filesystem::path& folder) {
    std::vector<std::pair<const char*, std::string>> contents{{"stats.csv", frames_csv(run)},
                                                              {"sides.csv", sides_csv(run)},
                                                              {"stress.csv", stress_csv(run)},
                                                              {"bubbles.csv", bubbles_csv(run)},
                                                              {"events.csv", events_csv(run)}};
    const char* const maze_name = "maze.csv";
    if (std::string mazes = maze_csv(run); !mazes.empty()) {
        contents.emplace_back(maze_name, std::move(mazes));
    } else {
        remove_file(folder / maze_name);
    }
    contents.emplace_back(kChartsScriptName, charts_script(run));
    make_folders(folder);
    StatisticsFiles files;
    for (const auto& [name, content] : contents) {
        files.paths.push_back(folder / name);
        write_file(files.paths.back(), std::as_bytes(std::span(content)));
    }
    const std::vector<std::filesystem::path> charts = chart_paths(folder);
    for (const std::filesystem::path& chart : charts) {
        remove_file(chart);
    }
    files.charts = draw_charts(folder / kChartsScriptName);
    for (const std::filesystem::path& chart : charts) {
        if (std::filesystem::exists(chart)) {
            files.paths.push_back(chart);
        }
    }
    return files;
}

}  // namespace foam::texgen
