// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/json/json_writer.h"

namespace foam::texgen {

/// Returns the object that a command without a foam prints with --json, for the command to add
/// members to: `status`, which is "complete".
Json json_report();

/// Returns the object of a command that runs frames: `status` ("complete", "no_equilibrium" or
/// "open_loop"), `failed_frame`, `closing_error`.
Json json_report(const RunOutcome& outcome);

/// Prints an object on stdout, in one line.
void print_json(const Json& object);

}  // namespace foam::texgen
