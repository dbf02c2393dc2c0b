// SPDX-License-Identifier: Apache-2.0

#include "core/files/content_text.h"
#include "core/files/file_io.h"
#include "texgen/animation/frame_assembly.h"
#include "texgen/animation/progress_meter.h"
#include "texgen/bake/fitted_ranges.h"
#include "texgen/cache/cache.h"
#include "texgen/cache/cache_files.h"
#include "texgen/cache/cache_writer.h"
#include "texgen/cache/stored_ranges.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>

namespace foam::texgen {

namespace {

void check(const BakeOptions& options) {
    if (options.frames.empty() || std::ranges::min(options.frames) < 1) {
        throw std::invalid_argument(
            "at least one frame is needed, and frame numbers must be at least 1");
    }
}

// Returns a LoopMemory that keeps the start of a boil in the file loop.json of a cache, or an empty
// LoopMemory for other loops. If the file cannot be read, the start is searched again.
LoopMemory loop_memory(const Preset& preset, const std::filesystem::path& folder) {
    if (preset.loop.kind != LoopKind::Boil) {
        return {};
    }
    const std::filesystem::path file = folder / "loop.json";
    LoopMemory memory;
    try {
        const Bytes content = read_file(file, kFoamInput);
        memory.content = as_text(content);
    } catch (const InputError&) {
        memory.content.clear();
    }
    memory.keep = [folder, file](const std::string& text) {
        make_folders(folder);
        write_file(file, std::as_bytes(std::span(text)));
    };
    return memory;
}

// Fits the automatic ranges of the maps of a preset and stores them in its cache. If this is not
// possible, for example because output.pattern is malformed, the cache is complete nevertheless,
// and `render` reports the error if it still exists.
void store_ranges(const Preset& preset,
                  const BakeOptions& options,
                  const std::filesystem::path& folder,
                  const ProgressCallback& on_progress) {
    try {
        const StoredRanges stored(preset, options.frames, folder);
        Preset fitted = preset;
        if (stored.load(fitted)) {
            return;
        }
        const Cache cache(folder);
        fit_automatic_ranges(fitted,
                             cache.frames_of(preset, SkippedEfforts::Ignored),
                             options.frames,
                             options.threads,
                             on_progress);
        stored.save(fitted);
    } catch (const std::invalid_argument&) {
        return;
    } catch (const InputError&) {
        return;
    } catch (const std::bad_alloc&) {
        return;
    }
}

}  // namespace

std::uint64_t estimated_cache_size(const Preset& preset,
                                   const std::vector<int>& frames,
                                   const std::filesystem::path& folder) {
    // Measured bytes per bubble and state: 63 in the preset sea_foam (400 bubbles), and 79 in the
    // presets potion (130 bubbles) and coarsening (3,000 bubbles).
    constexpr std::uint64_t kBytesPerBubble = 80;
    const std::vector<int> states = states_of(preset, frames, NextFrames::Included);
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
    CacheWriter writer(preset, options.frames, folder);
    const std::vector<int> states = states_of(preset, options.frames, NextFrames::Included);
    ProgressMeter meter(Phase::Frames, static_cast<int>(states.size()), on_progress);
    const auto write = [&](const SimulatedFrame& state) {
        writer.write(state);
        meter.add(state);
    };
    RunOutcome outcome = simulate_states(
        preset, options.threads, states, write, meter.for_source(), loop_memory(preset, folder));
    if (outcome.status == RunStatus::Complete) {
        store_ranges(preset, options, folder, on_progress);
    }
    return outcome;
}

}  // namespace foam::texgen
