// SPDX-License-Identifier: Apache-2.0

#include "texgen/cli/memory_need.h"

#include "texgen/bake/estimated_memory.h"
#include "texgen/cli/standard_error.h"

#include <fmt/format.h>

namespace foam::texgen {

MemoryNeed memory_to_simulate(const Preset& preset) {
    return {estimated_foam_memory(preset), "foam.bubbles"};
}

MemoryNeed memory_to_fill_cache(const Preset& preset, std::size_t frames, int threads) {
    return {estimated_cache_memory(preset, frames, threads), "--threads or foam.bubbles"};
}

MemoryNeed memory_to_bake(const Preset& preset, std::size_t frames, int threads) {
    return {estimated_memory(preset, frames, threads), "--threads, image.size or foam.bubbles"};
}

MemoryNeed memory_to_vary(std::span<const Preset> presets, const VariationDrawing& drawing) {
    return {estimated_memory(presets, drawing), "--threads, --width or foam.bubbles"};
}

std::string text_of(const MemoryNeed& need) {
    const std::string advice =
        need.settings_to_lower.empty() ? "" : fmt::format("; lower {}", need.settings_to_lower);
    return fmt::format("this needs about {}{}", amount_of_bytes(need.bytes), advice);
}

void warn_of_little_memory(const MemoryNeed& need) {
    const std::uint64_t available = available_memory();
    if (need.bytes > available) {
        print_stderr("foamtex: warning: only {} of memory are available, but {}",
                     amount_of_bytes(available),
                     text_of(need));
    }
}

}  // namespace foam::texgen
