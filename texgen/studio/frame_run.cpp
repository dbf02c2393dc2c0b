// SPDX-License-Identifier: Apache-2.0

#include "texgen/studio/frame_run.h"

#include "texgen/animation/camera.h"

namespace foam::texgen {

bool FrameRun::has_states(int frame) const {
    return !kept.empty() &&
           last_states[static_cast<std::size_t>(frame - 1)] <= kept.rbegin()->first;
}

int FrameRun::complete_frames() const {
    int complete = 0;
    while (complete < frames && has_states(complete + 1)) {
        ++complete;
    }
    return complete;
}

std::map<int, SimulatedFrame> FrameRun::states_for(const Preset& drawn_preset,
                                                   int frame,
                                                   NextFrames next_frames) const {
    std::map<int, SimulatedFrame> some;
    for (const int number : states_of(drawn_preset, {frame}, next_frames)) {
        some.emplace(number, kept.at(number));
    }
    return some;
}

void assemble(const std::map<int, SimulatedFrame>& kept,
              const Preset& drawn_preset,
              const std::vector<int>& numbers,
              NextFrames next_frames,
              const FrameVisitor& visit) {
    FrameAssembly assembly(drawn_preset, numbers, next_frames, visit);
    std::optional<View> view;
    for (const int number : assembly.states()) {
        SimulatedFrame state = kept.at(number);
        if (drawn_preset.shape.kind == FoamKind::Patch && number == 1) {
            view = camera_view(*state.frame, drawn_preset.image, drawn_preset.camera);
        }
        state.view = view;
        assembly.add(state);
    }
}

}  // namespace foam::texgen
