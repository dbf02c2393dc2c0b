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

/// The options that `bake` and `render` share, apart from RunArguments, as given on the command
/// line.
struct ImageArguments {
    std::optional<std::string> maps;
    std::vector<std::string> pack;  // the values of all --pack
    std::optional<std::string> normal_y;
    std::optional<std::string> out;
    std::optional<std::string> scene;  // formats, separated by commas
    std::optional<std::string> wrap;
    bool stats = false;
    bool dry_run = false;
    bool resume = false;
    bool json = false;
};

/// Adds --maps, --pack, --normal-y, --out, --scene, --wrap, --stats, --resume, --dry-run
/// and --json. The
/// arguments must outlive the parsing.
void add_image_options(CLI::App& command, ImageArguments& arguments);

/// Returns one assignment for each of the options --maps, --pack, --normal-y, --scene,
/// --wrap and --out that is given.
std::vector<Assignment> assignments_of(const ImageArguments& arguments);

/// Draws the frames of a preset, writes the image files and their manifest, and writes sheets,
/// scene files and statistics if requested. Returns the exit code. Throws the exceptions of
/// check_scenes, bake_recorded, write_sheets, write_scenes and write_statistics, and OutOfMemory in
/// place of std::bad_alloc.
///
/// With --json, prints a JSON object. Otherwise, if the run did not fail and the verbosity is not
/// Quiet, prints one line per map, or a single line if all maps share a file. For one frame the
/// line is the name of the image file, for several frames it is the file name pattern and the frame
/// range. The names of the sheets, the scene files and the statistics files follow.
ExitCode run_images(const Preset& preset,
                    const BakeOptions& options,
                    const ImageArguments& arguments,
                    const ProgressOptions& progress);

}  // namespace foam::texgen
