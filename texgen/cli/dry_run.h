// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/cli/exit_code.h"
#include "texgen/cli/image_arguments.h"
#include "texgen/cli/progress.h"

#include <span>

namespace foam::texgen {

/// Prints what runs would write and need (estimate_bake), as text or as a JSON object. Several runs
/// draw the frames of one simulation, so its time counts once. Leaves no file. Throws the
/// exceptions of estimate_bake. Precondition: there is a run.
ExitCode print_estimate(std::span<const ImageRun> runs, bool json, const ProgressOptions& progress);

}  // namespace foam::texgen
