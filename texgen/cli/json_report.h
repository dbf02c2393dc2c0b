// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/json/json_writer.h"

namespace foam::texgen {

/// Returns the JSON object that a command prints for --json in two cases:
///
/// - The command simulates nothing, for example `maps`.
/// - The command has several parts, each with an outcome of its own: the variations of the command
///   `vary`, or the jobs of the command `run`.
///
/// The only member is `status`: "complete", or "failed" if a part is not complete. The command adds
/// further members.
Json json_report(bool is_complete = true);

/// Returns the JSON object of a run that simulates or draws frames. The command adds further
/// members to these members:
///
/// - `status`: "complete", "no_equilibrium" or "open_loop"
/// - `failed_frame`: the first frame that could not be simulated; null if the run is complete
/// - `closing_error`: Simulation::closing_error, in mean bubble diameters; null if no cycle of a
///   loop was simulated, or if the error is infinite
/// - `relaxations`: Simulation::relaxations, how often a step had to relax the whole foam; null if
///   nothing was simulated
Json json_report(const RunOutcome& outcome);

/// Prints an object on stdout as one line.
void print_json(const Json& object);

}  // namespace foam::texgen
