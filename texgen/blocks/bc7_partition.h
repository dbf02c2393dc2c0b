// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/block_colors.h"

#include <array>

namespace foam::texgen::bc7 {

/// The number of partitions that best_partitions returns.
inline constexpr int kTriedPartitions = 2;

/// Returns the partitions (kPartitionMasks) whose subsets are closest to two lines of colors, the
/// best one first. The measure is the sum of the squared distances of the colors from the principal
/// axis of their subset, without alpha.
std::array<int, kTriedPartitions> best_partitions(const Colors& colors);

}  // namespace foam::texgen::bc7
