// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The content of frame 1: the foam in equilibrium, or the seeding diagram of straight films.
enum class FirstFrame { Equilibrium, Diagram };

/// The foam times that the frames show. Frame 1 shows the foam at time warm_up. The time from frame
/// i to frame i + 1 is time_step * step_growth^(i - 1).
struct FramesOptions {
    int count = 48;
    FirstFrame first = FirstFrame::Equilibrium;
    double time_step = 1.0;    // foam time from frame 1 to frame 2
    double step_growth = 1.0;  // factor from each time step to the next
    double warm_up = 0.0;      // foam time simulated before frame 1
};

Keys<FramesOptions> frames_keys();

}  // namespace foam::texgen
