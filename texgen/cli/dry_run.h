// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"
#include "texgen/cli/image_arguments.h"
#include "texgen/cli/progress.h"

#include <span>

namespace foam::texgen {

/// Prints an estimate of the files, the memory and the time of the given runs (estimate_bake). If
/// `json` is true, the estimate is a JSON object. Otherwise it is text, and is not printed if the
/// verbosity is Quiet. Several runs draw the frames of one simulation, so the time of the
/// simulation counts once. Leaves no file. Each run is measured by a short bake; if this bake
/// fails, prints the reason and returns the exit code of the failure (report_failure). Throws the
/// exceptions of estimate_bake. Precondition: there is a run.
ExitCode print_estimate(std::span<const ImageRun> runs, bool json, const ProgressOptions& progress);

}  // namespace foam::texgen
