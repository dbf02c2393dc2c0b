// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/image_sizes.h"

#include "texgen/bake/file_pattern.h"
#include "texgen/cli/options.h"
#include "texgen/manifest/bake_recorder.h"
#include "texgen/preset/simulation_keys.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <span>
#include <stdexcept>
#include <string>

namespace foam::texgen {

namespace {

/// Throws std::invalid_argument if the images of the last preset cannot be drawn in the same run as
/// those of the others. The presets differ only in their image sizes and in the folders of their
/// files. `sizes` is the value of --size, for the message.
void check_last(std::span<const Preset> presets, const std::string& sizes) {
    const Preset& last = presets.back();
    const std::string last_size = fmt::format("{}x{}", last.image.width, last.image.height);
    for (const Preset& other : presets.first(presets.size() - 1)) {
        const std::string other_size = fmt::format("{}x{}", other.image.width, other.image.height);
        if (last_size == other_size) {
            throw std::invalid_argument(
                fmt::format("--size {}: {} occurs twice", sizes, last_size));
        }
        if (simulation_hash(last) != simulation_hash(other)) {
            throw std::invalid_argument(
                fmt::format("--size {}: {} and {} have different aspect ratios, so that they show "
                            "different foams; bake them one after the other",
                            sizes,
                            other_size,
                            last_size));
        }
        if (!last.output.scene.empty() && manifest_folder(last) == manifest_folder(other)) {
            throw std::invalid_argument(
                fmt::format("--size {}: the scene files of {} and {} would have the same names; "
                            "put {{size}} into the name of a folder in output.pattern, which is "
                            "'{}'",
                            sizes,
                            other_size,
                            last_size,
                            last.output.pattern));
        }
    }
}

}  // namespace

void describe_several_sizes(CLI::App& command) {
    command.get_option("--size")
        ->description("Image size in pixels; several sizes show the same foam, each in a folder")
        ->option_text("W[xH],...");
}

std::vector<Preset> presets_of_sizes(const RunArguments& arguments,
                                     const std::function<Preset(const RunArguments&)>& load) {
    if (!arguments.size || arguments.size->find(',') == std::string::npos) {
        return {load(arguments)};
    }
    std::vector<Preset> presets;
    for (const std::string& size : split_words(*arguments.size)) {
        RunArguments one = arguments;
        one.size = size;
        one.quiet = arguments.quiet || !presets.empty();
        OutputOptions& output = presets.emplace_back(load(one)).output;
        output.pattern = with_size_folder(output.pattern);
        output.sheet_pattern = with_size_folder(output.sheet_pattern);
        check_last(presets, *arguments.size);
    }
    return presets;
}

}  // namespace foam::texgen
