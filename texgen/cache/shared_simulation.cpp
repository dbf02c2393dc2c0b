// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/shared_simulation.h"

#include "core/files/file_io.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/cache_writer.h"

#include <algorithm>
#include <set>
#include <utility>

namespace foam::texgen {

SharedSimulation::SharedSimulation(const Preset& preset, std::vector<int> frames, int threads)
    : preset_(preset), frames_(std::move(frames)), threads_(threads) {}

// Simulates the foam, stores all states if possible, and gives the assembly only those states that
// the assembly needs.
RunOutcome SharedSimulation::simulate(FrameAssembly& assembly,
                                      const ProgressCallback& on_progress) {
    std::optional<CacheWriter> writer;  // set as long as every state could be stored
    const auto store_if_possible = [&](const auto& store) {
        try {
            store();
        } catch (const OutputError&) {
            writer.reset();
            folder_.reset();
        }
    };
    store_if_possible([&] {
        folder_.emplace();
        writer.emplace(preset_, frames_, folder_->path());
    });
    const std::vector<int> needed = assembly.states();
    efforts_.clear();
    const auto add = [&](const SimulatedFrame& state) {
        if (writer) {
            store_if_possible([&] { writer->write(state); });
        }
        const int number = state.frame->number;
        efforts_[number] = state.effort;
        if (std::ranges::binary_search(needed, number)) {
            assembly.add(state);
        } else {
            assembly.add_effort(state.effort);
        }
    };
    const std::vector<int> states = states_of(preset_, frames_, NextFrames::Included);
    return simulate_states(preset_, threads_, states, add, on_progress);
}

FrameSource SharedSimulation::stored_frames(const Preset& drawn) const {
    const auto skipped_effort = [this](int number) -> std::optional<FrameEffort> {
        const auto entry = efforts_.find(number);
        return entry != efforts_.end() ? std::optional(entry->second) : std::nullopt;
    };
    return frames_from_states(
        drawn,
        {[this](int number) { return cache_->state(number); }, skipped_effort},
        outcome_->closing_error);
}

FrameSource SharedSimulation::source(const Preset& drawn) {
    return [this, drawn](const std::vector<int>& numbers,
                         NextFrames next_frames,
                         const FrameVisitor& on_frame,
                         const ProgressCallback& on_progress) {
        if (!outcome_) {
            FrameAssembly assembly(drawn, numbers, next_frames, on_frame);
            outcome_ = simulate(assembly, on_progress);
            if (outcome_->status == RunStatus::Complete && folder_) {
                cache_.emplace(folder_->path());
            }
        } else if (cache_) {
            stored_frames(drawn)(numbers, next_frames, on_frame, on_progress);
        } else if (outcome_->status == RunStatus::Complete) {
            simulation_of(drawn, threads_)(numbers, next_frames, on_frame, on_progress);
        }
        return *outcome_;
    };
}

std::vector<int> united(const std::vector<int>& some, const std::vector<int>& others) {
    std::set<int> all(some.begin(), some.end());
    all.insert(others.begin(), others.end());
    return {all.begin(), all.end()};
}

std::vector<int> frames_to_simulate(const std::vector<Preset>& presets,
                                    const std::vector<int>& frames) {
    std::vector<int> all = united(frames, {});
    for (const Preset& preset : presets) {
        if (has_automatic_ranges(preset)) {
            all = united(all, frames_to(preset.frames.count));
        }
    }
    return all;
}

}  // namespace foam::texgen
