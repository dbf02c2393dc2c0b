// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace foam::texgen {

/// The exit codes of the program. `foamtex --help` and `foamtex compare --help` also list them.
/// `compare` differs from the other commands: like OpenImageIO's idiff, it returns its Verdict (0
/// to 4, image/comparison.h) as the exit code. The codes 1 and 2 are verdicts, so `compare` returns
/// codes of the BSD header sysexits.h in place of InternalFailure and BadRequest (code_for_command
/// in program.cpp).
enum class ExitCode : int {
    Success = 0,
    InternalFailure = 1,          // a bug, or out of memory
    BadRequest = 2,               // wrong command line or preset, including a missing preset file
    NoEquilibrium = 3,            // the foam did not reach equilibrium, or its loop did not close
    BadInput = 4,                 // an input file is unreadable or malformed
    OutputFailed = 5,             // an output could not be written
    CheckFailed = 6,              // verify: a check failed
    CompareBadRequest = 64,       // compare: wrong command line or tolerances (EX_USAGE)
    CompareInternalFailure = 70,  // compare: a bug, or out of memory (EX_SOFTWARE)
    HungUp = 129,                 // 128 + SIGHUP: the terminal was closed
    Interrupted = 130,            // 128 + SIGINT
    Terminated = 143,             // 128 + SIGTERM
};

}  // namespace foam::texgen
