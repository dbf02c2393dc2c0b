// SPDX-License-Identifier: Apache-2.0

#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/cache/cache.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cache/packed_file.h"
#include "texgen/cache/simulation_keys.h"
#include "texgen/cache/state_codec.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace foam::texgen {

namespace {

// Writes states to a cache as they are simulated. cache.json is written immediately before the
// first state, so a simulation that fails before its first state creates no cache.
class CacheWriter {
  public:
    CacheWriter(CacheInfo info, std::filesystem::path folder)
        : info_(std::move(info)), folder_(std::move(folder)) {}

    void write(const SimulatedFrame& state) {
        if (!begun_) {
            begin(state.closing_error);
        }
        if (first_pressures_.empty() && !state.record->first_pressures.empty()) {
            first_pressures_ = state.record->first_pressures;
            // "scale" is the kind of this packed file: these pressures define the scale of all
            // frames.
            write_packed(pressures_path(folder_),
                         {"scale", info_.simulation},
                         pack_numbers(first_pressures_));
        }
        write_packed(state_path(folder_, state.frame->number),
                     {"state", info_.simulation},
                     pack_state(state, first_pressures_));
    }

  private:
    void begin(const std::optional<double>& closing_error) {
        begun_ = true;
        info_.closing_error = closing_error;
        make_folders(folder_);
        write_info(info_, folder_);
    }

    CacheInfo info_;
    std::filesystem::path folder_;
    bool begun_ = false;
    std::vector<double> first_pressures_;
};

void check(const BakeOptions& options) {
    if (options.frames.empty() || std::ranges::min(options.frames) < 1) {
        throw std::invalid_argument(
            "at least one frame is needed, and frame numbers must be at least 1");
    }
}

}  // namespace

std::uint64_t estimated_cache_size(const Preset& preset,
                                   const std::vector<int>& frames,
                                   const std::filesystem::path& folder) {
    // Measured bytes per bubble and state: 63 in the preset sea_foam (400 bubbles), and 79 in
    // potion (130 bubbles) and in coarsening with 3,000 bubbles.
    constexpr std::uint64_t kBytesPerBubble = 80;
    const std::vector<int> states =
        FrameAssembly(preset, frames, NextFrames::Included, {}).states();
    const auto missing = std::ranges::count_if(states, [&](int number) {
        std::error_code ignored;
        return !std::filesystem::exists(state_path(folder, number), ignored);
    });
    return static_cast<std::uint64_t>(missing) * kBytesPerBubble *
           static_cast<std::uint64_t>(preset.seeding.bubbles);
}

RunOutcome simulate_into_cache(const Preset& preset,
                               const BakeOptions& options,
                               const std::filesystem::path& folder,
                               const ProgressCallback& on_progress) {
    check(options);
    CacheWriter writer({.preset = preset,
                        .version = FOAMTEX_VERSION,
                        .simulation = simulation_hash(preset),
                        .frames = options.frames,
                        .closing_error = {}},
                       folder);
    const std::vector<int> states =
        FrameAssembly(preset, options.frames, NextFrames::Included, {}).states();
    ProgressMeter meter(Phase::Frames, static_cast<int>(states.size()), on_progress);
    const auto write = [&](const SimulatedFrame& state) {
        writer.write(state);
        meter.add(state);
    };
    return simulate_states(preset, options.threads, states, write, meter.for_source());
}

}  // namespace foam::texgen
