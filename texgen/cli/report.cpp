#include "texgen/cli/report.h"

#include <fmt/core.h>

#include <cstdio>

namespace foam::texgen {

void print_files(std::span<const std::filesystem::path> files) {
    for (const std::filesystem::path& file : files) {
        fmt::print("{}\n", file.string());
    }
}

ExitCode report_no_equilibrium(int frame) {
    fmt::print(stderr, "foamtex: frame {}: the foam found no equilibrium\n", frame);
    return ExitCode::NoEquilibrium;
}

}  // namespace foam::texgen
