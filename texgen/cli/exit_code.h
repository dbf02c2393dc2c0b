#pragma once

namespace foam::texgen {

/// What the program returns to the shell; the help of the program lists the same. `compare` returns
/// its Verdict instead, and BadInput, as idiff does.
enum class ExitCode : int {
    Success = 0,
    InternalFailure = 1,  // a bug, or out of memory
    BadRequest = 2,       // the command line or a preset, a missing preset file too
    NoEquilibrium = 3,    // the foam could not be brought to equilibrium, or its loop not be closed
    BadInput = 4,         // an input file is unreadable or malformed
    OutputFailed = 5,     // an output could not be written
    CheckFailed = 6,      // verify: something does not hold
};

}  // namespace foam::texgen
