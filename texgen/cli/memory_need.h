// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/memory.h"
#include "texgen/preset/preset.h"
#include "texgen/variations/drawn_variations.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <string_view>

namespace foam::texgen {

/// The estimated memory that a run needs.
struct MemoryNeed {
    std::uint64_t bytes = 0;
    // The options and keys that the user can lower so that the run needs less memory, as a part of
    // a message, such as "image.size or foam.bubbles". Empty if there are none.
    std::string_view settings_to_lower{};
};

/// Returns the memory of a run that simulates a preset and draws nothing (estimated_foam_memory).
MemoryNeed memory_to_simulate(const Preset& preset);

/// Returns the memory of a run that simulates the given number of frames of a preset into a cache
/// (estimated_cache_memory).
MemoryNeed memory_to_fill_cache(const Preset& preset, std::size_t frames, int threads);

/// Returns the memory of a bake of the given number of frames of a preset (estimated_memory).
MemoryNeed memory_to_bake(const Preset& preset, std::size_t frames, int threads);

/// Returns the memory of draw_variations and of the sheet (estimated_memory in
/// drawn_variations.h).
MemoryNeed memory_to_vary(std::span<const Preset> presets, const VariationDrawing& drawing);

/// Returns the part of a message that says how much memory a run needs and what to lower.
std::string text_of(const MemoryNeed& need);

/// Prints a warning on stderr if a run needs more memory than is available (available_memory).
void warn_of_little_memory(const MemoryNeed& need);

/// Returns run(). If run() throws std::bad_alloc, throws OutOfMemory, whose message says how much
/// memory the run needs.
template <class Run>
auto with_memory(const MemoryNeed& need, const Run& run) {
    try {
        return run();
    } catch (const std::bad_alloc&) {
        throw OutOfMemory(text_of(need));
    }
}

}  // namespace foam::texgen
