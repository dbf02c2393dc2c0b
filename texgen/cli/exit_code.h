// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The exit codes of the program. The help of the program also lists them. `compare` differs: like
/// OpenImageIO's idiff, it returns its Verdict (0 to 3, image/compare.h) as the exit code,
/// unless an exception or lost output gives one of these codes.
enum class ExitCode : int {
    Success = 0,
    InternalFailure = 1,  // a bug, or out of memory
    BadRequest = 2,       // wrong command line or preset, including a missing preset file
    NoEquilibrium = 3,    // the foam did not reach equilibrium, or its loop did not close
    BadInput = 4,         // an input file is unreadable or malformed
    OutputFailed = 5,     // an output could not be written
    CheckFailed = 6,      // verify: a check failed
    Interrupted = 130,    // 128 + SIGINT
    Terminated = 143,     // 128 + SIGTERM
};

}  // namespace foam::texgen
