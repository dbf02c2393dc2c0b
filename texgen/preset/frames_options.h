// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The content of frame 1: the foam in equilibrium, or the foam before its first equilibration,
/// which is a Voronoi diagram with straight films (foam/seeding.h in core).
enum class FirstFrame { Equilibrium, Diagram };

/// The times that the frames show. Foam time is the time t in the law of coarsening (E6). Frame 1
/// shows the foam at the foam time warm_up. The time from frame i to frame i + 1 is time_step *
/// step_growth^(i - 1).
struct FramesOptions {
    int count = 48;  // number of frames
    FirstFrame first = FirstFrame::Equilibrium;
    double time_step = 1.0;    // foam time from frame 1 to frame 2
    double step_growth = 1.0;  // quotient of each time step and the preceding time step
    double warm_up = 0.0;      // foam time that is simulated before frame 1
};

Keys<FramesOptions> frames_keys();

}  // namespace foam::texgen
