// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cli/run_arguments.h"
#include "texgen/preset/assignment.h"
#include "texgen/preset/preset.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): the library spells it so
class App;
}

namespace foam::texgen {

/// The options that `bake` and `render` share, apart from RunArguments, and the option --watch of
/// `bake`, as given on the command line.
struct ImageArguments {
    std::optional<std::string> maps;
    std::vector<std::string> pack;  // the values of all options --pack
    std::optional<std::string> normal_y;
    std::optional<std::string> out;
    std::optional<std::string> scene;  // formats, separated by commas
    std::optional<std::string> wrap;
    bool stats = false;
    bool dry_run = false;
    bool resume = false;
    bool json = false;
    // --watch, which only `bake` has. If true, no warning is printed when images or sheets are
    // replaced.
    bool watch = false;
};

/// One preset whose images are to be drawn, and the options for drawing them.
struct ImageRun {
    Preset preset;
    BakeOptions options;
};

/// Adds --maps, --pack, --normal-y, --out, --scene, --wrap, --stats, --resume, --dry-run and
/// --json. The arguments must outlive the parsing.
void add_image_options(CLI::App& command, ImageArguments& arguments);

/// Returns one assignment for each of the options --maps, --pack, --normal-y, --scene, --wrap and
/// --out that is given.
std::vector<Assignment> assignments_of(const ImageArguments& arguments);

/// If --out is given and no --set gives output.sheet_pattern, returns the preset with its sheets
/// beside its images (with_sheets_beside_images). Otherwise returns the preset unchanged. Throws
/// the exceptions of with_sheets_beside_images.
Preset with_sheets_placed(Preset preset, const RunArguments& run, const ImageArguments& arguments);

}  // namespace foam::texgen
