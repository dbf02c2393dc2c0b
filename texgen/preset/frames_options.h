#pragma once

#include "texgen/keys/key.h"

namespace foam::texgen {

/// The content of frame 1: the foam, or the diagram that it is made from, before equilibrium.
enum class FirstFrame { Equilibrium, Diagram };

/// The times that become pictures: frame 1 shows the foam at time warm_up, and frame i + 1 shows it
/// time_step step_growth^(i - 1) after frame i.
struct FramesOptions {
    int count = 48;
    FirstFrame first = FirstFrame::Equilibrium;
    double time_step = 1.0;    // foam time from frame 1 to frame 2
    double step_growth = 1.0;  // factor from each time step to the next
    double warm_up = 0.0;      // foam time simulated before frame 1
};

Keys<FramesOptions> frames_keys();

}  // namespace foam::texgen
