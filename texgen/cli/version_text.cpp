// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/version_text.h"

#include "core/parallel/parallel_for.h"
#include "core/parallel/simd_level.h"
#include "texgen/cli/build_facts.h"
#include "texgen/preset/algorithm_version.h"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace foam::texgen {

namespace {

constexpr const char* kVersion = "foamtex " FOAMTEX_VERSION R"(
License: Apache-2.0. Presets, and the images that they make: CC0-1.0 (public domain).)";

std::string details() {
    std::vector<std::string> levels;
    for (const SimdLevel level : available_simd_levels()) {
        levels.emplace_back(name_of(level));
    }
    return fmt::format(
        "\n\nalgorithms    {}\ncommit        {}\ncompiler      {}\nbuild         {}\nlibraries     "
        "{}\n"
        "instructions  {} (available: {})\nthreads       {}",
        kAlgorithmVersion,
        kCommit,
        kCompiler,
        kBuild,
        kLibraries,
        name_of(simd_level()),
        fmt::join(levels, ", "),
        thread_count(0));
}

}  // namespace

std::string version_text(bool is_detailed) {
    return is_detailed ? kVersion + details() : kVersion;
}

}  // namespace foam::texgen
