#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cli/exit_code.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <string>
#include <vector>

namespace foam::texgen {

/// What the commands that draw images are told of them.
struct ImageArguments {
    std::optional<std::string> maps;
    std::optional<std::string> normal_y;
    std::optional<std::string> out;
    bool stats = false;
    bool resume = false;
    bool json = false;
};

/// --maps, --normal-y, --out, --stats, --resume, --json; the arguments have to outlive the parsing.
void add_image_options(CLI::App& command, ImageArguments& arguments);

/// The options that stand for a key.
std::vector<Assignment> assignments_of(const ImageArguments& arguments);

/// Draws the frames of a preset into files, with a manifest, and statistics where asked for; says
/// where they are.
ExitCode run_images(const Preset& preset,
                    const BakeOptions& options,
                    const ImageArguments& arguments,
                    Verbosity verbosity);

}  // namespace foam::texgen
