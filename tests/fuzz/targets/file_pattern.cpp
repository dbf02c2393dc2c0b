// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/file_pattern.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/image/format.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <stdexcept>

namespace foam::fuzz {

void fuzz_file_pattern(std::string_view input) {
    texgen::Preset preset;
    preset.name = "foam";
    preset.output.pattern = input;
    const auto pattern =
        unless_rejected<std::invalid_argument>([&] { return texgen::FilePattern(preset); });
    if (!pattern) {
        return;
    }
    const std::filesystem::path first = pattern->path("albedo", 1);
    const std::filesystem::path second = pattern->path("albedo", 23456);
    require(pattern->is_vector() || texgen::find_format(first.native()) == &pattern->format(),
            "a file name has the suffix of its format");
    require(first.native().starts_with(pattern->folder().native()),
            "the folder of the pattern contains each file");
    const bool distinct = unless_rejected<std::invalid_argument>([&] {
                              pattern->check_distinct(2, 1);
                              return true;
                          }).value_or(false);
    require(distinct == (first != second), "check_distinct finds equal names of two frames");
    pattern->path_pattern("albedo");
}

}  // namespace foam::fuzz
