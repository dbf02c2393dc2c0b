// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/preset/preset.h"

#include <cstddef>
#include <cstdint>

namespace foam::texgen {

/// Returns the estimated peak memory, in bytes, of a process that brings a foam with the given
/// number of bubbles to equilibrium.
std::uint64_t estimated_foam_memory(std::size_t bubbles);

/// Returns the estimated peak memory, in bytes, of a process that simulates a preset and draws
/// nothing.
std::uint64_t estimated_foam_memory(const Preset& preset);

/// Returns the estimated peak memory, in bytes, of a process that simulates the given number of
/// frames of a preset into a cache. The process then draws reduced images on thread_count(threads)
/// threads, in order to fit the automatic ranges of maps. The estimate is too large by the memory
/// of these images if there are no such ranges.
std::uint64_t estimated_cache_memory(const Preset& preset, std::size_t frames, int threads);

/// Returns the estimated peak memory, in bytes, of a process that bakes the given number of frames
/// of a preset on thread_count(threads) threads. The process then joins the frames into the sheets
/// that output.sheets selects. The estimate is usually right within a factor of 1.5.
std::uint64_t estimated_memory(const Preset& preset, std::size_t frames, int threads);

}  // namespace foam::texgen
