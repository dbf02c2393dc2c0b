// SPDX-License-Identifier: Apache-2.0

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

/// The options of `bake` and `render` for images, as given on the command line.
struct ImageArguments {
    std::optional<std::string> maps;
    std::optional<std::string> normal_y;
    std::optional<std::string> out;
    bool stats = false;
    bool resume = false;
    bool json = false;
};

/// Adds --maps, --normal-y, --out, --stats, --resume and --json. The arguments must outlive the
/// parsing.
void add_image_options(CLI::App& command, ImageArguments& arguments);

/// Returns one assignment for each given option that sets a key of the preset.
std::vector<Assignment> assignments_of(const ImageArguments& arguments);

/// Draws the frames of a preset, writes the image files and their manifest, and writes statistics
/// if requested. With --json, prints a JSON object. Otherwise prints the name of the image file of
/// each map or, for several frames, its file name pattern and the frame range, and the names of the
/// statistics files; prints nothing if the run failed or the verbosity is Quiet. Returns the exit
/// code. Throws the exceptions of bake_recorded.
ExitCode run_images(const Preset& preset,
                    const BakeOptions& options,
                    const ImageArguments& arguments,
                    const ProgressOptions& progress);

}  // namespace foam::texgen
