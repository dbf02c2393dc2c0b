// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/bake/bake.h"

#include <string>

namespace foam::texgen {

/// The level of detail with which a run reports its progress on stderr.
enum class Verbosity {
    Quiet,
    Normal,   // a progress bar if stderr is a terminal
    Verbose,  // a line per frame
};

/// Returns the text of the progress bar, without a newline. Example:
/// "[######------------------] 12/48  583 bubbles  0:14 left".
std::string progress_bar(const RunProgress& progress);

/// Returns the line that reports a frame. It ends with the wall time since the run began. Example:
/// "frame 12: 583 bubbles, area error 1.2e-14, angle error 3.1e-15, 4.21 s".
std::string progress_line(const RunProgress& progress);

/// Returns a callback that reports progress on stderr. The bar is drawn only if stderr is a
/// terminal. It is in color only if the environment variable NO_COLOR is unset or empty. Calls
/// handle_stop_signals; after SIGINT or SIGTERM the callback throws Interrupted, unless all frames
/// are done.
ProgressCallback progress_reporter(Verbosity verbosity);

}  // namespace foam::texgen
