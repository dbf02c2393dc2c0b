// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"
#include "texgen/cli/exit_code.h"
#include "texgen/cli/progress.h"
#include "texgen/preset/preset.h"

namespace foam::texgen {

/// Prints what a bake would write and need (estimate_bake), as text or as a JSON object. Leaves no
/// file. Throws the exceptions of estimate_bake.
ExitCode print_estimate(const Preset& preset,
                        const BakeOptions& options,
                        bool json,
                        const ProgressOptions& progress);

}  // namespace foam::texgen
