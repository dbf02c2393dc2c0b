// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/animation/simulate_frames.h"
#include "texgen/json/json_writer.h"

namespace foam::texgen {

/// Returns the JSON object (--json) of a command that simulates no foam. Its only member is
/// `status`, which is "complete". The command adds further members.
Json json_report();

/// Returns the JSON object of a command that simulates or draws frames. Its members are `status`
/// ("complete", "no_equilibrium" or "open_loop"), `failed_frame` (null if complete) and
/// `closing_error` (in mean bubble diameters, Simulation::closing_error; null if no cycle of a loop
/// was simulated, or if infinite). The command adds further members.
Json json_report(const RunOutcome& outcome);

/// Prints an object on stdout as one line.
void print_json(const Json& object);

}  // namespace foam::texgen
