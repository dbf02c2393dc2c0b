#pragma once

#include "texgen/stats/record.h"

#include <filesystem>
#include <vector>

namespace foam::texgen {

/// Writes the tables (csv.h) and the charts (charts.h) into a folder, which is made as needed, and
/// names the files. Each appears under its name only when it is complete. Throws OutputError.
std::vector<std::filesystem::path> write_statistics(const RunRecord& run,
                                                    const std::filesystem::path& folder);

}  // namespace foam::texgen
