// SPDX-License-Identifier: Apache-2.0

#include "texgen/stats/charts.h"

#include "texgen/image/external_program.h"
#include "texgen/stats/charts_script.h"

#include <fmt/core.h>

#include <optional>

namespace foam::texgen {

std::string charts_script(const RunRecord& run) {
    return fmt::format("film_tension = {}\n{}", run.film_tension, charts_script_text());
}

ChartStatus draw_charts(const std::filesystem::path& script) {
    const std::optional<int> code =
        run_external({"gnuplot", script.filename().string()},
                     {.folder = script.parent_path(), .shows_errors = false});
    if (!code) {
        return ChartStatus::NoGnuplot;
    }
    return *code == 0 ? ChartStatus::Drawn : ChartStatus::GnuplotFailed;
}

std::vector<std::filesystem::path> chart_paths(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    for (const char* const name : {"mean_area",
                                   "second_moment",
                                   "sides",
                                   "pressures",
                                   "growth_rates",
                                   "stress",
                                   "seconds"}) {
        paths.push_back(folder / (std::string(name) + ".svg"));
    }
    return paths;
}

}  // namespace foam::texgen
