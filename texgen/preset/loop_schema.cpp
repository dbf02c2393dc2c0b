#include "texgen/preset/loop_schema.h"

#include "texgen/preset/value_kinds.h"
#include "texgen/preset/key_of_member.h"
#include "texgen/preset/refusal.h"

#include <array>
#include <string_view>

namespace foam::texgen {

namespace {

constexpr double kLargestAmplitude = 0.9;
constexpr double kLargestStrain = 0.4;
constexpr int kMostPeriods = 100;
constexpr double kShortestFade = 0.01;
constexpr double kWidestSpread = 0.95;

constexpr Choices<LoopKind, 6> kLoopKinds = {{{{"none", LoopKind::None},
                                               {"breathe", LoopKind::Breathe},
                                               {"shear", LoopKind::Shear},
                                               {"drift", LoopKind::Drift},
                                               {"flow", LoopKind::Flow},
                                               {"pingpong", LoopKind::PingPong}}}};

void check_torus(const Preset& preset, std::span<const Assignment> assignments) {
    const LoopOptions& loop = preset.loop;
    if (preset.shape.kind == FoamKind::Torus) {
        return;
    }
    if (loop.kind == LoopKind::Shear || loop.kind == LoopKind::Drift) {
        refuse_last(
            assignments, {"loop.kind", "foam.domain"}, "a patch has no torus to shear or travel");
    }
    if (loop.kind == LoopKind::Flow) {
        refuse_last(assignments,
                    {"loop.kind", "foam.domain"},
                    "a patch loses its gas, and so has no steady state to flow in");
    }
}

void check_drift(const Preset& preset, std::span<const Assignment> assignments) {
    const LoopOptions& loop = preset.loop;
    const bool drifts = loop.drift != std::array{0, 0};
    if (loop.kind == LoopKind::Drift && !drifts) {
        refuse_last(
            assignments, {"loop.kind", "loop.drift"}, "loop.drift says how far: [0, 1] is one up");
    }
    if (drifts && !loop.closes_itself() && !loop.is_cross_faded()) {
        refuse_last(assignments,
                    {"loop.drift", "loop.kind"},
                    "loop.drift is for loop.kind \"drift\", \"breathe\", \"shear\" and \"flow\"");
    }
}

void check_frames(const Preset& preset, std::span<const Assignment> assignments) {
    const bool is_pingpong = preset.loop.kind == LoopKind::PingPong;
    if (is_pingpong && (preset.frames.count < 2 || preset.frames.count % 2 != 0)) {
        refuse_last(assignments,
                    {"frames.count", "loop.kind"},
                    "of a pingpong, frames.count must be even: both ends are shown once");
    }
    if (!is_pingpong && preset.frames.first == FirstFrame::Diagram) {
        refuse_last(
            assignments, {"frames.first", "loop.kind"}, "a loop has no frame of the diagram");
    }
    if (!is_pingpong && !preset.events.empty()) {
        refuse_last(assignments, {"loop.kind"}, "but for a pingpong, a loop has no events");
    }
}

// A flow is the same at all times, and goes on.
void check_flow(const Preset& preset, std::span<const Assignment> assignments) {
    if (preset.loop.kind != LoopKind::Flow) {
        return;
    }
    if (preset.frames.time_step == 0.0) {
        refuse_last(assignments,
                    {"frames.time_step", "loop.kind"},
                    "of a flow, frames.time_step must be above 0: bubbles vanish as gas diffuses");
    }
    if (preset.frames.step_growth != 1.0) {
        refuse_last(assignments,
                    {"frames.step_growth", "loop.kind"},
                    "of a flow, frames.step_growth must be 1: it is as fast at all times");
    }
}

}  // namespace

std::vector<Key> loop_keys() {
    using Options = LoopOptions;
    const auto one = [](std::string_view path, auto kind, std::string_view meaning, auto member) {
        return key(path, kind, meaning, &Preset::loop, member);
    };
    std::vector<Key> keys = {
        one("loop.kind",
            kLoopKinds,
            "what brings the foam back within frames.count frames: bubbles that swell and shrink, "
            "shear to and fro, travel alone, come to be as others vanish and fade into the "
            "beginning, or the frames shown backwards",
            &Options::kind),
        one("loop.amplitude",
            Reals{0.0, kLargestAmplitude},
            "of \"breathe\": how far areas swing, in parts of them; of \"shear\": how far the "
            "strain does, at most 0.4",
            &Options::amplitude),
        one("loop.drift",
            IntegerPairs{{-kMostPeriods, kMostPeriods}},
            "whole images that the foam travels in a loop, to the right and up",
            &Options::drift),
        one("loop.cycles",
            Integers{1, 1000},
            "how many may pass before frame 1 until the loop closes",
            &Options::cycles),
        one("loop.fade",
            Reals{kShortestFade, 1.0},
            "of \"flow\": the part of the frames, at the end, that fade into the beginning",
            &Options::fade),
        one("loop.fade_spread",
            Reals{0.0, kWidestSpread},
            "of \"flow\": how much of the fade passes before its last places begin, so that never "
            "all of the foam is between two; 0 fades the image at once",
            &Options::fade_spread),
        one("loop.growth",
            Integers{1, 1000},
            "of \"flow\": frames that a new bubble takes to the mean area",
            &Options::growth)};
    keys[2].kind = FoamKind::Torus;
    return keys;
}

void check_loop(const Preset& preset, std::span<const Assignment> assignments) {
    check_drift(preset, assignments);
    if (preset.loop.kind == LoopKind::None) {
        return;
    }
    check_torus(preset, assignments);
    check_frames(preset, assignments);
    check_flow(preset, assignments);
    if (preset.loop.kind == LoopKind::Shear && preset.loop.amplitude > kLargestStrain) {
        refuse_last(assignments, {"loop.amplitude", "loop.kind"}, "of a shear, at most 0.4");
    }
}

}  // namespace foam::texgen
