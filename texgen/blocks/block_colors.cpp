// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/block_colors.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace foam::texgen {

namespace {

// The principal axis of the colors of a subset.
struct Axis {
    Color mean{};
    Color direction{};  // of length 1; 0 if all colors are equal
};

Color mean_of(const Colors& colors, Subset subset) {
    Color mean{};
    for (unsigned rest = subset; rest != 0; rest &= rest - 1) {
        const Color& color = colors.texels[static_cast<std::size_t>(std::countr_zero(rest))];
        for (std::size_t c = 0; c < 4; ++c) {
            mean[c] += color[c];
        }
    }
    for (float& component : mean) {
        component /= static_cast<float>(std::popcount(subset));
    }
    return mean;
}

using Matrix = std::array<Color, 4>;

Matrix scatter_matrix(const Colors& colors, Subset subset, const Color& mean) {
    Matrix scatter{};
    for (unsigned rest = subset; rest != 0; rest &= rest - 1) {
        const Color& color = colors.texels[static_cast<std::size_t>(std::countr_zero(rest))];
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = 0; b < 4; ++b) {
                scatter[a][b] += (color[a] - mean[a]) * (color[b] - mean[b]);
            }
        }
    }
    return scatter;
}

// Finds the axis by power iteration, which begins with the column of the largest variance.
Axis principal_axis(const Colors& colors, Subset subset) {
    constexpr int kIterations = 4;
    Axis axis{mean_of(colors, subset), {}};
    const Matrix scatter = scatter_matrix(colors, subset, axis.mean);
    std::size_t widest = 0;
    for (std::size_t c = 1; c < 4; ++c) {
        widest = scatter[c][c] > scatter[widest][widest] ? c : widest;
    }
    Color direction = scatter[widest];
    for (int k = 0; k < kIterations; ++k) {
        float square = 0.0F;
        for (const float component : direction) {
            square += component * component;
        }
        if (square < 1e-6F) {
            return axis;
        }
        const float scale = 1.0F / std::sqrt(square);
        for (std::size_t c = 0; c < 4; ++c) {
            axis.direction[c] = direction[c] * scale;
        }
        direction = {};
        for (std::size_t a = 0; a < 4; ++a) {
            for (std::size_t b = 0; b < 4; ++b) {
                direction[a] += scatter[b][a] * axis.direction[b];
            }
        }
    }
    return axis;
}

}  // namespace

Line principal_line(const Colors& colors, Subset subset) {
    const Axis axis = principal_axis(colors, subset);
    float low = std::numeric_limits<float>::max();
    float high = -low;
    for (unsigned rest = subset; rest != 0; rest &= rest - 1) {
        const Color& color = colors.texels[static_cast<std::size_t>(std::countr_zero(rest))];
        float along = 0.0F;
        for (std::size_t c = 0; c < 4; ++c) {
            along += (color[c] - axis.mean[c]) * axis.direction[c];
        }
        low = std::min(low, along);
        high = std::max(high, along);
    }
    Line line{};
    for (std::size_t c = 0; c < 4; ++c) {
        line[0][c] = axis.mean[c] + low * axis.direction[c];
        line[1][c] = axis.mean[c] + high * axis.direction[c];
    }
    return line;
}

}  // namespace foam::texgen
