#pragma once

#include "texgen/bake/bake.h"

#include <string>

namespace foam::texgen {

/// How much a bake says on stderr while it runs.
enum class Verbosity {
    Quiet,
    Normal,   // a bar, on a terminal only
    Verbose,  // a line per frame
};

/// "[#####---------------]  12/48  583 bubbles  0:14 left", without an end of line.
std::string progress_bar(const RunProgress& progress);

/// "frame 12: 583 bubbles, area error 1.2e-14, angle error 3.1e-15, 4.21 s"
std::string progress_line(const RunProgress& progress);

/// Reports to stderr. A bar needs a terminal, and colour in it needs NO_COLOR to be unset or empty.
ProgressCallback progress_reporter(Verbosity verbosity);

}  // namespace foam::texgen
