// SPDX-License-Identifier: Apache-2.0

#include "texgen/cache/cache.h"

#include "texgen/animation/camera.h"
#include "texgen/animation/frame_assembly.h"
#include "texgen/bake/frame_range.h"
#include "texgen/cache/byte_stream.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/state_codec.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <system_error>
#include <utility>

namespace foam::texgen {

namespace {

// Returns true if a file exists; an error of the file system counts as a missing file.
bool is_file(const std::filesystem::path& path) {
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

// Returns unpack(content of a packed file). Throws InputError, whose message names the file, if the
// file cannot be read or its content is malformed.
template <class Unpack>
auto read_content(const std::filesystem::path& path,
                  const PackedLabel& label,
                  const Unpack& unpack) {
    const Bytes content = read_packed(path, label);
    try {
        return unpack(content);
    } catch (const BadContent& error) {
        fail_to_read(path, error.what());
    }
}

}  // namespace

Cache::Cache(std::filesystem::path folder)
    : folder_(std::move(folder)), info_(read_info(folder_)) {}

// Returns the pressures in pressures.foam, or an empty list if the file does not exist. The file is
// read anew for each state: a simulation that still runs writes it after cache.json, but before the
// first state that needs it.
std::vector<double> Cache::first_pressures() const {
    const std::filesystem::path path = pressures_path(folder_);
    return is_file(path) ? read_content(path, {"scale", info_.simulation}, unpack_numbers)
                         : std::vector<double>();
}

SimulatedFrame Cache::state(int number) const {
    const std::filesystem::path path = state_path(folder_, number);
    if (!is_file(path)) {
        throw InputError(fmt::format(
            "the cache '{}' has no state {}; only frames {} can be drawn, and only after "
            "'foamtex simulate' has written their states",
            folder_.string(),
            number,
            format_frame_range(info_.frames)));
    }
    SimulatedFrame found =
        read_content(path, {"state", info_.simulation}, [this](std::span<const std::byte> bytes) {
            return unpack_state(bytes, first_pressures());
        });
    if (found.frame->number != number) {
        throw InputError(fmt::format("cannot read '{}': the file contains state {}, not state {}",
                                     path.string(),
                                     found.frame->number,
                                     number));
    }
    return found;
}

// Only the states that the frames of the cache need are counted. The folder may contain others,
// which an earlier simulation of more frames has left; the states of the cache include their
// effort.
FrameSource Cache::frames_of(const Preset& preset, SkippedEfforts skipped) const {
    std::vector<int> counted;
    if (skipped == SkippedEfforts::Counted) {
        counted = states_of(info_.preset, info_.frames, NextFrames::Included);
    }
    const auto skipped_effort = [this, counted](int number) -> std::optional<FrameEffort> {
        return std::ranges::binary_search(counted, number) ? std::optional(state(number).effort)
                                                           : std::nullopt;
    };
    return frames_from_states(preset,
                              {[this](int number) { return state(number); }, skipped_effort},
                              info_.closing_error);
}

FrameSource frames_from_states(const Preset& preset,
                               StoredStates stored,
                               std::optional<double> closing_error) {
    return
        [preset, stored = std::move(stored), closing_error](const std::vector<int>& numbers,
                                                            NextFrames next_frames,
                                                            const FrameVisitor& on_frame,
                                                            const ProgressCallback& on_progress) {
            std::optional<View> view;
            FrameAssembly assembly(preset, numbers, next_frames, on_frame);
            RunProgress progress{.phase = Phase::States,
                                 .total = static_cast<int>(assembly.states().size())};
            const auto report = [&] {
                if (on_progress && progress.done > 0) {
                    on_progress(progress);  // may throw, so that the user can end the reading
                }
            };
            const auto skip = [&](int number) {
                report();
                if (const auto effort = stored.skipped_effort(number)) {
                    assembly.add_effort(*effort);
                }
            };
            int next = 1;  // number of the first state that was neither added nor skipped
            for (const int number : assembly.states()) {
                for (; next < number; ++next) {
                    skip(next);
                }
                report();
                SimulatedFrame state = stored.state(number);
                if (preset.shape.kind == FoamKind::Patch && number == 1) {
                    view = camera_view(*state.frame, preset.image, preset.camera);
                }
                state.view = view;
                state.closing_error = closing_error;
                assembly.add(state);
                ++progress.done;
                ++next;
            }
            return RunOutcome{RunStatus::Complete, 0, closing_error};
        };
}

}  // namespace foam::texgen
