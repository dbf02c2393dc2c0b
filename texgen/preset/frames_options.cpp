// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/frames_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<FramesOptions> frames_keys() {
    using Options = FramesOptions;
    constexpr Choices<FirstFrame> kFirstFrames = {
        {{{"equilibrium", FirstFrame::Equilibrium}, {"diagram", FirstFrame::Diagram}}}};
    constexpr Reals kTimes{0.0, 1e6};
    return {
        key("count", Integers{1, 100'000}, "number of frames of the animation", &Options::count)
            .in("frames"),
        key("first",
            kFirstFrames,
            "what frame 1 shows: the foam in equilibrium, or the diagram of straight films from "
            "which the foam is brought to equilibrium",
            &Options::first),
        key("time_step",
            kTimes,
            "foam time from frame 1 to frame 2; every later step is frames.step_growth times as "
            "long as the step before it",
            &Options::time_step)
            .in("foam time")
            .unused_with("loop.kind", {"drift"}),
        key("step_growth",
            Reals{0.1, 10.0},
            "factor from each time step to the next; values above 1 compensate for a foam "
            "that slows down",
            &Options::step_growth)
            .used_with("loop.kind", {"none", "flow", "pingpong"}),
        key("warm_up",
            kTimes,
            "foam time that is simulated before frame 1 (the warm-up); with frames.first = "
            "\"diagram\", between frames 1 and 2",
            &Options::warm_up)
            .in("foam time"),
        key("smoothing",
            Reals{0.0, 1000.0},
            "number of frames by which the colors of bubbles in albedo, and the maps pressure and "
            "contour, lag behind the foam: they use averages of pressures, areas and numbers of "
            "sides over about this many frames, so that they do not jump where bubbles vanish; 0 "
            "uses present values",
            &Options::smoothing)
            .in("frames")};
}

}  // namespace foam::texgen
