// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/loop.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<LoopOptions> loop_keys() {
    using Options = LoopOptions;
    constexpr int kMaxPeriods = 100;
    constexpr Choices<LoopKind, 6> kKinds = {{{{"none", LoopKind::None},
                                               {"breathe", LoopKind::Breathe},
                                               {"shear", LoopKind::Shear},
                                               {"drift", LoopKind::Drift},
                                               {"flow", LoopKind::Flow},
                                               {"pingpong", LoopKind::PingPong}}}};
    return {
        key("kind",
            kKinds,
            "what brings the foam back within frames.count frames: bubbles that swell and shrink, "
            "shear to and fro, travel alone, come to be as others vanish and fade into the "
            "beginning, or the frames shown backwards",
            &Options::kind),
        key("amplitude",
            Reals{0.0, 0.9},
            "of \"breathe\": how far areas swing, in parts of them; of \"shear\": how far the "
            "strain does, at most 0.4",
            &Options::amplitude),
        key("drift",
            IntegerPairs{{-kMaxPeriods, kMaxPeriods}},
            "whole images that the foam travels in a loop, to the right and up",
            &Options::drift)
            .only_for("foam.domain", {"torus"}),
        key("cycles",
            Integers{1, 1000},
            "how many may pass before frame 1 until the loop closes",
            &Options::cycles),
        key("fade",
            Reals{0.01, 1.0},
            "of \"flow\": the part of the frames, at the end, that fade into the beginning",
            &Options::fade),
        key("fade_spread",
            Reals{0.0, 0.95},
            "of \"flow\": how much of the fade passes before its last places begin, so that never "
            "all of the foam is between two; 0 fades the image at once",
            &Options::fade_spread),
        key("growth",
            Integers{1, 1000},
            "of \"flow\": frames that a new bubble takes to the mean area",
            &Options::growth)};
}

}  // namespace foam::texgen
