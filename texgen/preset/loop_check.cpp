// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/loop_check.h"

#include "texgen/preset/rejection.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace foam::texgen {

namespace {

// The smallest number of frames of the loop "boil" (check_boil).
constexpr int kMinBoilFrames = 10;
// The smallest width of an eddy, in foam units (check_current).
constexpr int kMinEddyWidth = 3;

void check_torus(const Preset& preset, std::span<const Assignment> assignments) {
    const LoopOptions& loop = preset.loop;
    if (preset.shape.kind == FoamKind::Torus) {
        return;
    }
    if (loop.kind == LoopKind::Shear || loop.kind == LoopKind::Drift) {
        reject_last(assignments,
                    {"loop.kind", "foam.domain"},
                    "the loops \"shear\" and \"drift\" need foam.domain = \"torus\"");
    }
    if (loop.kind == LoopKind::Flow) {
        reject_last(assignments,
                    {"loop.kind", "foam.domain"},
                    "the loop \"flow\" needs foam.domain = \"torus\": a patch loses gas and has no "
                    "steady state");
    }
}

void check_drift(const Preset& preset, std::span<const Assignment> assignments) {
    const LoopOptions& loop = preset.loop;
    const bool drifts = loop.drift != std::array{0, 0};
    if (loop.kind == LoopKind::Drift && !drifts) {
        reject_last(
            assignments,
            {"loop.kind", "loop.drift"},
            "the loop \"drift\" needs loop.drift; [0, 1], for example, moves the foam up by the "
            "height of one image");
    }
    if (drifts && !loop.returns_to_start() && !loop.is_cross_faded()) {
        reject_last(
            assignments,
            {"loop.drift", "loop.kind"},
            "loop.drift is only allowed with loop.kind = \"drift\", \"breathe\", \"shear\", "
            "\"boil\" or \"flow\"");
    }
}

// Checks that an eddy is at least kMinEddyWidth foam units wide; the mean bubble area is 1 in foam
// units. The current then hardly varies along a film, and the film stays an arc. A single eddy is
// always allowed.
void check_current(const Preset& preset, std::span<const Assignment> assignments) {
    const LoopOptions& loop = preset.loop;
    if (loop.current == 0.0) {
        return;
    }
    const double aspect = static_cast<double>(preset.image.width) / preset.image.height;
    const double shorter_side = std::sqrt(preset.seeding.bubbles * std::min(aspect, 1.0 / aspect));
    const int max_eddies = std::max(static_cast<int>(shorter_side / kMinEddyWidth), 1);
    if (loop.eddies > max_eddies) {
        reject_last(assignments,
                    {"loop.eddies", "loop.current", "foam.bubbles", "image.size"},
                    fmt::format("loop.eddies must be at most {} for {} bubbles, so that an eddy is "
                                "at least {} bubbles wide",
                                max_eddies,
                                preset.seeding.bubbles,
                                kMinEddyWidth));
    }
}

void check_frames(const Preset& preset, std::span<const Assignment> assignments) {
    const bool is_pingpong = preset.loop.kind == LoopKind::PingPong;
    if (is_pingpong && (preset.frames.count < 2 || preset.frames.count % 2 != 0)) {
        reject_last(assignments,
                    {"frames.count", "loop.kind"},
                    "the loop \"pingpong\" needs an even frames.count: it shows the first and the "
                    "last state once and all states between them twice");
    }
    if (!is_pingpong && preset.frames.first == FirstFrame::Diagram) {
        reject_last(
            assignments,
            {"frames.first", "loop.kind"},
            "frames.first = \"diagram\" is only allowed with loop.kind = \"none\" or \"pingpong\"");
    }
    if (!is_pingpong && !preset.events.empty()) {
        reject_last(assignments,
                    {"loop.kind"},
                    "events are only allowed with loop.kind = \"none\" or \"pingpong\"");
    }
}

// Checks the time steps of a flow. A flow is a steady state, so its time steps must be equal and
// above 0.
void check_flow(const Preset& preset, std::span<const Assignment> assignments) {
    if (preset.loop.kind != LoopKind::Flow) {
        return;
    }
    if (preset.frames.time_step == 0.0) {
        reject_last(assignments,
                    {"frames.time_step", "loop.kind"},
                    "the loop \"flow\" needs frames.time_step above 0: if no time passes, no gas "
                    "diffuses and no bubble vanishes");
    }
    if (preset.frames.step_growth != 1.0) {
        reject_last(assignments,
                    {"frames.step_growth", "loop.kind"},
                    "the loop \"flow\" needs frames.step_growth = 1: its speed is constant");
    }
}

void check_boil(const Preset& preset, std::span<const Assignment> assignments) {
    if (preset.loop.kind != LoopKind::Boil) {
        return;
    }
    if (preset.loop.cycles < 2) {
        reject_last(assignments,
                    {"loop.cycles", "loop.kind"},
                    "the loop \"boil\" needs loop.cycles of at least 2, because it is closed only "
                    "when two cycles in a row return to their start");
    }
    if (preset.frames.count < kMinBoilFrames) {
        reject_last(
            assignments,
            {"frames.count", "loop.kind"},
            fmt::format(
                "the loop \"boil\" needs frames.count of at least {}: each boiling bubble is "
                "absent for a tenth of the loop, which must be at least one frame",
                kMinBoilFrames));
    }
}

}  // namespace

void check_loop(const Preset& preset, std::span<const Assignment> assignments) {
    check_drift(preset, assignments);
    check_current(preset, assignments);
    if (preset.loop.kind == LoopKind::None) {
        return;
    }
    check_torus(preset, assignments);
    check_frames(preset, assignments);
    check_flow(preset, assignments);
    check_boil(preset, assignments);
    if (preset.loop.kind == LoopKind::Shear && preset.loop.amplitude > kMaxShearAmplitude) {
        reject_last(assignments,
                    {"loop.amplitude", "loop.kind"},
                    fmt::format("loop.amplitude must be at most {} with loop.kind = \"shear\"",
                                kMaxShearAmplitude));
    }
}

}  // namespace foam::texgen
