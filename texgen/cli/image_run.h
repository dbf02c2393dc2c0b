// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"
#include "texgen/cli/image_arguments.h"
#include "texgen/cli/progress.h"

#include <span>

namespace foam::texgen {

/// Draws the frames of each run, writes the image files and their manifest, and writes sheets and
/// scene files if requested. The runs differ only in the size of their images and in the source of
/// their frames. The statistics, if requested, are those of the first run. Ends with the first run
/// that fails. With --dry-run, writes nothing and prints an estimate instead (print_estimate).
/// Returns the exit code. Throws the exceptions of check_scenes, check_sheets, check_sheet_folder,
/// bake_recorded, write_sheets, write_scenes, write_statistics and print_estimate. Throws
/// OutputError if the folder of the statistics cannot be written, and OutOfMemory if memory for a
/// bake cannot be allocated. Precondition: `runs` is not empty.
///
/// With --json, prints a JSON object; for several runs, its member `sizes` has the object of each
/// run that has ended. Without --json, unless the verbosity is Quiet, prints names of files for
/// each run that succeeded. There is one line per image, or a single line if all images share a
/// file. For one frame the line is the name of the image file, for several frames it is the file
/// name pattern and the frame range. The names of the sheets, the scene files and the statistics
/// files follow.
ExitCode run_images(std::span<const ImageRun> runs,
                    const ImageArguments& arguments,
                    const ProgressOptions& progress);

}  // namespace foam::texgen
