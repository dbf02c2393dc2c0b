// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/blocks/block_colors.h"

#include <array>
#include <limits>

namespace foam::texgen::bc7 {

using Code = std::array<int, 4>;

/// Two endpoints as a mode stores them: codes, lowest bits, and the colors that they stand for.
struct Endpoints {
    std::array<Code, 2> codes{};
    std::array<int, 2> lowest{};
    std::array<Code, 2> colors{};
};

/// A subset in one mode: its endpoints, an index per texel of the block, and the sum of squared
/// errors. Texels of the other subset have the index 0.
struct Fit {
    Endpoints ends;
    std::array<int, kBlockTexels> indices{};
    float error = std::numeric_limits<float>::infinity();
};

/// Approximates the colors of a subset in mode 1 or in mode 6.
Fit fit_mode1(const Colors& colors, Subset subset);
Fit fit_mode6(const Colors& colors, Subset subset);

}  // namespace foam::texgen::bc7
