// SPDX-License-Identifier: Apache-2.0

#include "texgen/bake/file_pattern.h"

#include "tests/fuzz/fuzz_target.h"
#include "texgen/image/format.h"
#include "texgen/preset/preset.h"

#include <filesystem>
#include <stdexcept>
#include <string>

namespace foam::fuzz {

namespace {

// Parses the patterns that the program makes from the pattern of a preset. Precondition: the
// pattern of the preset is valid.
void check_changed(texgen::Preset preset) {
    const std::string pattern = preset.output.pattern;
    preset.output.pattern = texgen::with_size_folder(pattern);
    texgen::FilePattern{preset};
    preset.output.pattern = texgen::without_shared_folders(pattern);
    texgen::FilePattern{preset};
}

}  // namespace

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
    const bool distinct_maps = unless_rejected<std::invalid_argument>([&] {
                                   pattern->check_distinct(1, 2);
                                   return true;
                               }).value_or(false);
    require(distinct_maps || !pattern->stores_all_maps_in_one_file(),
            "check_distinct allows several maps in a file with layers");
    check_changed(preset);
    unless_rejected<std::invalid_argument>([&] { return texgen::FilePattern(input); });
}

}  // namespace foam::fuzz
