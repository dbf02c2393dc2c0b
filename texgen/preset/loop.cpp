// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/loop.h"

#include "texgen/keys/value_kinds.h"

#include <fmt/core.h>

#include <string>

namespace foam::texgen {

namespace {

// Returns the key that selects the kind of loop.
Key<LoopOptions> kind_key() {
    constexpr Choices<LoopKind, 7> kKinds = {{{{"none", LoopKind::None},
                                               {"breathe", LoopKind::Breathe},
                                               {"shear", LoopKind::Shear},
                                               {"boil", LoopKind::Boil},
                                               {"drift", LoopKind::Drift},
                                               {"flow", LoopKind::Flow},
                                               {"pingpong", LoopKind::PingPong}}}};
    return key(
        "kind",
        kKinds,
        "how the animation loops after frames.count frames: bubbles grow and shrink "
        "(breathe), the foam is sheared to and fro (shear), some bubbles vanish and are "
        "born again (boil), the foam moves by a whole number of image widths and heights "
        "(drift), bubbles are renewed and the last frames fade into the first ones (flow), or "
        "the second half shows the first half backwards (pingpong)",
        &LoopOptions::kind);
}

constexpr int kMaxPeriods = 100;  // largest number of widths or heights of `drift`

// Returns the keys of the cross-fade of a flow.
Keys<LoopOptions> flow_keys() {
    return {key("fade",
                Reals{0.01, 1.0},
                "for \"flow\": fraction of the frames, at the end, that fade into the beginning",
                &LoopOptions::fade)
                .in("fraction of the frames")
                .used_with("loop.kind", {"flow"}),
            key("fade_spread",
                Reals{0.0, 0.95},
                "for \"flow\": fraction of the fade after which the last region of the image "
                "begins to fade; 0 fades the whole image at the same time",
                &LoopOptions::fade_spread)
                .in("fraction of the fade")
                .used_with("loop.kind", {"flow"}),
            key("growth",
                Integers{1, 1000},
                "for \"flow\": number of frames in which a new bubble grows to the mean area",
                &LoopOptions::growth)
                .in("frames")
                .used_with("loop.kind", {"flow"})};
}

}  // namespace

Keys<LoopOptions> loop_keys() {
    // A key stores its meaning as a string_view, so the text must be static.
    static const std::string amplitude_meaning = fmt::format(
        "for \"breathe\": relative amplitude of every bubble's area; for \"boil\": relative "
        "amplitude of the areas of the bubbles that do not vanish; for \"shear\": amplitude of the "
        "strain, at most {}",
        kMaxShearAmplitude);
    const Keys<LoopOptions> common = {
        kind_key(),
        key("amplitude", Reals{0.0, 0.9}, amplitude_meaning, &LoopOptions::amplitude)
            .in("fraction of the area, or strain, selected by loop.kind")
            .used_with("loop.kind", {"breathe", "boil", "shear"}),
        key("boiling",
            Reals{0.001, 0.5},
            "for \"boil\": fraction of the bubbles that vanish and are born again, each once in "
            "a loop",
            &LoopOptions::boiling)
            .in("fraction of the bubbles")
            .used_with("loop.kind", {"boil"}),
        key("rise",
            Reals{0.15, 5.0},
            "for \"boil\": largest rise of the area of each bubble that vanishes, relative to its "
            "area without a loop; lower values close the loop sooner; where the foam does not "
            "return to its first state, the rise is reduced",
            &LoopOptions::rise)
            .in("fraction of the area")
            .used_with("loop.kind", {"boil"}),
        key("drift",
            IntegerPairs{{-kMaxPeriods, kMaxPeriods}},
            "number of whole images that the foam moves in a loop, to the right and up",
            &LoopOptions::drift)
            .in("image widths and heights")
            .only_for("foam.domain", {"torus"}),
        key("current",
            Reals{0.0, 0.6},
            "typical strain from a current that moves bubbles around and back to their start in "
            "every loop: 0.1 is gentle, at 0.3 the foam clearly flows, larger values stretch "
            "bubbles",
            &LoopOptions::current)
            .in("strain")
            .only_for("foam.domain", {"torus"}),
        key("eddies",
            Integers{1, 16},
            "number of eddies of the current, counted along the shorter side of the image; the "
            "current moves bubbles by about loop.current / 6 of the size of an eddy",
            &LoopOptions::eddies)
            .in("eddies")
            .only_for("foam.domain", {"torus"})
            .unused_with("loop.current", {"0.0"}),
        key("cycles",
            Integers{1, 1000},
            "largest number of cycles that are simulated before frame 1 so that the loop "
            "closes",
            &LoopOptions::cycles)
            .in("cycles")
            .used_with("loop.kind", {"breathe", "boil", "shear"})};
    return joined({common, flow_keys()});
}

}  // namespace foam::texgen
