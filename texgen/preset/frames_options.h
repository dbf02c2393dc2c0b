// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The content of frame 1: the foam in equilibrium, or the foam before its first equilibration,
/// which is a Voronoi diagram with straight films (foam/seeding.h in core).
enum class FirstFrame { Equilibrium, Diagram };

/// The number of frames and the times that they show. Foam time is the time t in the law of
/// coarsening (E6 in core/EQUATIONS.md). Without a loop (loop.h), frame 1 shows the foam at the
/// foam time warm_up, and each further frame is one time step later. The step from frame i to frame
/// i + 1 is time_step * step_growth^(i - 1). With FirstFrame::Diagram, frame 1 shows the foam at
/// time 0, and the warm-up is simulated between frame 1 and the first time step.
struct FramesOptions {
    int count = 48;  // number of frames
    FirstFrame first = FirstFrame::Equilibrium;
    double time_step = 1.0;    // foam time of the step to frame 2
    double step_growth = 1.0;  // factor from each time step to the next
    double warm_up = 0.0;      // foam time that is simulated before the first time step (warm-up)
    // The number of frames by which colors lag behind the foam: they show averages of pressures,
    // areas and numbers of sides over about this many frames (RecentAverages). With 0, they show
    // present values.
    double smoothing = 0.0;
};

Keys<FramesOptions> frames_keys();

}  // namespace foam::texgen
