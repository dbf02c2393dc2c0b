// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/shared_simulation.h"

#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"

#include <algorithm>
#include <set>
#include <utility>

namespace foam::texgen {

SharedSimulation::SharedSimulation(const Preset& preset, std::vector<int> frames, int threads)
    : preset_(preset), frames_(std::move(frames)), threads_(threads) {}

const RunOutcome& SharedSimulation::simulate(const ProgressCallback& on_progress) {
    if (outcome_) {
        return *outcome_;
    }
    ProgressCallback report;
    if (on_progress) {
        report = [&](RunProgress progress) {
            progress.phase = progress.phase == Phase::Frames ? Phase::States : progress.phase;
            on_progress(progress);
        };
    }
    const BakeOptions options{.frames = frames_, .threads = threads_};
    folder_.emplace();
    outcome_ = simulate_into_cache(preset_, options, folder_->path(), report);
    if (outcome_->status == RunStatus::Complete) {
        cache_.emplace(folder_->path());
    }
    return *outcome_;
}

FrameSource SharedSimulation::source(const Preset& drawn) {
    return [this, drawn](const std::vector<int>& numbers,
                         NextFrames next_frames,
                         const FrameVisitor& on_frame,
                         const ProgressCallback& on_progress) {
        const RunOutcome& simulated = simulate(on_progress);
        if (simulated.status == RunStatus::Complete) {
            cache_->frames_of(drawn)(numbers, next_frames, on_frame, on_progress);
        }
        return simulated;
    };
}

std::vector<int> frames_to_simulate(const std::vector<Preset>& presets,
                                    const std::vector<int>& frames) {
    std::set<int> all(frames.begin(), frames.end());
    for (const Preset& preset : presets) {
        if (has_automatic_ranges(preset)) {
            const std::vector<int> animation = frames_to(preset.frames.count);
            all.insert(animation.begin(), animation.end());
        }
    }
    return {all.begin(), all.end()};
}

}  // namespace foam::texgen
