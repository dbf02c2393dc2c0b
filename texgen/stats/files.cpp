#include "texgen/stats/files.h"

#include "texgen/chart/svg_chart.h"
#include "texgen/image/file_io.h"
#include "texgen/stats/charts.h"
#include "texgen/stats/csv.h"

#include <span>
#include <string>
#include <utility>

namespace foam::texgen {

std::vector<std::filesystem::path> write_statistics(const RunRecord& run,
                                                    const std::filesystem::path& folder) {
    std::vector<std::pair<std::string, std::string>> contents{{"stats.csv", frames_csv(run)},
                                                              {"sides.csv", sides_csv(run)}};
    for (const NamedChart& named : charts(run)) {
        contents.emplace_back(named.name + ".svg", to_svg(named.chart));
    }
    make_folders(folder);
    std::vector<std::filesystem::path> files;
    for (const auto& [name, content] : contents) {
        files.push_back(folder / name);
        write_file(files.back(), std::as_bytes(std::span(content)));
    }
    return files;
}

}  // namespace foam::texgen
