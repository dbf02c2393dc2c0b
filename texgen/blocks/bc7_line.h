// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/lanes.h"
#include "texgen/blocks/texel_block.h"

#include <cstddef>

// Finds, for each subset of a block, the line that is closest to the colors of the subset: the
// principal axis of the colors. Processes several blocks at once. Colors are given relative to the
// color of texel 0, so that all sums are integers below 2^24, which floats represent exactly.

namespace foam::texgen::bc7 {

/// The channels of one color, or of one difference of colors, for each of several blocks. The
/// channels of a color are numbers from 0 to 255.
template <class Simd, std::size_t kChannels>
using ColorOf = KernelArray<typename Simd::Floats, kChannels>;

/// The colors of the texels of several blocks.
template <class Simd, std::size_t kChannels>
using ColorLanes = KernelArray<ColorOf<Simd, kChannels>, kBlockTexels>;

/// The two ends of one line of colors for each of several blocks.
template <class Simd, std::size_t kChannels>
using LineOf = KernelArray<ColorOf<Simd, kChannels>, 2>;

/// Returns the differences of all colors from the color of texel 0.
template <class Simd, std::size_t kChannels>
FOAM_INLINE ColorLanes<Simd, kChannels> relative(const ColorLanes<Simd, kChannels>& colors) {
    ColorLanes<Simd, kChannels> differences;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        for (std::size_t c = 0; c < kChannels; ++c) {
            differences[k][c] = colors[k][c] - colors[0][c];
        }
    }
    return differences;
}

/// The subset to which each texel belongs, for several blocks. Each block has a partition of its
/// own.
template <class Simd, std::size_t kSubsets>
struct Membership {
    using Ints = typename Simd::Ints;

    /// Returns the element of `values` for the subset to which a texel belongs.
    template <class Value>
    FOAM_INLINE Value select(const KernelArray<Value, kSubsets>& values, std::size_t texel) const {
        Value value = values[0];
        for (std::size_t s = 1; s < kSubsets; ++s) {
            value = Simd::select(masks[s][texel], values[s], value);
        }
        return value;
    }

    /// masks[s][k] is -1 for the blocks in which texel k belongs to subset s, and 0 for the other
    /// blocks. Not used if there is only one subset.
    KernelArray<KernelArray<Ints, kBlockTexels>, kSubsets> masks;
};

/// Adds up values of texels for each subset. The values are integers, so that the sum of the first
/// subset can be found by subtraction without an error.
template <class Simd, std::size_t kSubsets>
struct SubsetSum {
    using Floats = typename Simd::Floats;

    FOAM_INLINE void add(const Floats& value,
                         const Membership<Simd, kSubsets>& membership,
                         std::size_t texel) {
        sums[0] += value;
        for (std::size_t s = 1; s < kSubsets; ++s) {
            sums[s] += Simd::select(membership.masks[s][texel], value, Floats());
        }
    }
    /// Completes the sum of the first subset. Until this call, it is the sum over all texels; this
    /// call subtracts the sums of the other subsets. Call this function exactly once, after the
    /// last call of add.
    FOAM_INLINE void finish() {
        for (std::size_t s = 1; s < kSubsets; ++s) {
            sums[0] = sums[0] - sums[s];
        }
    }

    KernelArray<Floats, kSubsets> sums;
};

/// Returns the number of pairs (c, d) of channels with c <= d.
constexpr std::size_t pairs_of(std::size_t channels) {
    return channels * (channels + 1) / 2;
}

/// Sums over the texels of a subset: their number, the sum of their relative colors, and sums of
/// products of two channels. There is a sum of products for each pair of channels c <= d. The pairs
/// are ordered by c and then by d.
template <class Simd, std::size_t kChannels>
struct ColorSums {
    using Floats = typename Simd::Floats;

    FOAM_INLINE void add(const ColorSums& other) {
        count += other.count;
        for (std::size_t c = 0; c < kChannels; ++c) {
            colors[c] += other.colors[c];
        }
        for (std::size_t k = 0; k < pairs_of(kChannels); ++k) {
            products[k] += other.products[k];
        }
    }
    FOAM_INLINE ColorSums without(const ColorSums& other) const {
        ColorSums rest;
        rest.count = count - other.count;
        for (std::size_t c = 0; c < kChannels; ++c) {
            rest.colors[c] = colors[c] - other.colors[c];
        }
        for (std::size_t k = 0; k < pairs_of(kChannels); ++k) {
            rest.products[k] = products[k] - other.products[k];
        }
        return rest;
    }

    Floats count;
    ColorOf<Simd, kChannels> colors;
    KernelArray<Floats, pairs_of(kChannels)> products;
};

/// Returns the sums of a subset that contains only one texel, given its color.
template <class Simd, std::size_t kChannels>
FOAM_INLINE ColorSums<Simd, kChannels> sums_of(const ColorOf<Simd, kChannels>& color) {
    ColorSums<Simd, kChannels> sums;
    sums.count = 1.0F;
    sums.colors = color;
    std::size_t pair = 0;
    for (std::size_t c = 0; c < kChannels; ++c) {
        for (std::size_t d = c; d < kChannels; ++d) {
            sums.products[pair++] = color[c] * color[d];
        }
    }
    return sums;
}

/// The scatter matrix of the colors of a subset: the products of their differences from the mean,
/// summed over the texels.
template <class Simd, std::size_t kChannels>
using Scatter = KernelArray<ColorOf<Simd, kChannels>, kChannels>;

template <class Simd, std::size_t kChannels>
FOAM_INLINE Scatter<Simd, kChannels> scatter_of(const ColorSums<Simd, kChannels>& sums,
                                                const ColorOf<Simd, kChannels>& mean) {
    Scatter<Simd, kChannels> scatter;
    std::size_t pair = 0;
    for (std::size_t c = 0; c < kChannels; ++c) {
        for (std::size_t d = c; d < kChannels; ++d) {
            scatter[c][d] = scatter[d][c] = sums.products[pair++] - sums.colors[c] * mean[d];
        }
    }
    return scatter;
}

/// Returns a vector along the principal axis, or the zero vector if all colors are equal. The
/// vector is found by power iteration, which begins with the column of the channel with the largest
/// variance. Each iteration divides the vector by half the trace of the matrix, so that the numbers
/// of the vector do not overflow.
template <class Simd, std::size_t kChannels>
FOAM_INLINE ColorOf<Simd, kChannels> principal_axis(const Scatter<Simd, kChannels>& scatter) {
    using Floats = typename Simd::Floats;
    constexpr int kIterations = 4;
    Floats trace = 1e-3F;  // avoids a division by 0 if all colors are equal
    ColorOf<Simd, kChannels> axis = scatter[0];
    Floats widest;
    for (std::size_t c = 0; c < kChannels; ++c) {
        trace += scatter[c][c];
        const auto is_wider = Simd::less(widest, scatter[c][c]);
        widest = Simd::larger(widest, scatter[c][c]);
        for (std::size_t d = 0; d < kChannels; ++d) {
            axis[d] = Simd::select(is_wider, scatter[c][d], axis[d]);
        }
    }
    const Floats unit = Floats(2.0F) / trace;
    for (int k = 0; k < kIterations; ++k) {
        ColorOf<Simd, kChannels> next;
        for (std::size_t c = 0; c < kChannels; ++c) {
            for (std::size_t d = 0; d < kChannels; ++d) {
                next[c] += scatter[c][d] * axis[d];
            }
            next[c] = next[c] * unit;
        }
        axis = next;
    }
    return axis;
}

/// Returns the sums over the colors of each subset.
template <class Simd, std::size_t kSubsets, std::size_t kChannels>
FOAM_INLINE KernelArray<ColorSums<Simd, kChannels>, kSubsets> subset_sums(
    const ColorLanes<Simd, kChannels>& relative_colors,
    const Membership<Simd, kSubsets>& membership) {
    using Floats = typename Simd::Floats;
    SubsetSum<Simd, kSubsets> count;
    KernelArray<SubsetSum<Simd, kSubsets>, kChannels> colors;
    KernelArray<SubsetSum<Simd, kSubsets>, pairs_of(kChannels)> products;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        const auto terms = sums_of<Simd, kChannels>(relative_colors[k]);
        count.add(terms.count, membership, k);
        for (std::size_t c = 0; c < kChannels; ++c) {
            colors[c].add(terms.colors[c], membership, k);
        }
        for (std::size_t pair = 0; pair < products.size(); ++pair) {
            products[pair].add(terms.products[pair], membership, k);
        }
    }
    count.finish();
    KernelArray<ColorSums<Simd, kChannels>, kSubsets> sums;
    for (std::size_t c = 0; c < kChannels; ++c) {
        colors[c].finish();
    }
    for (std::size_t pair = 0; pair < products.size(); ++pair) {
        products[pair].finish();
    }
    for (std::size_t s = 0; s < kSubsets; ++s) {
        sums[s].count = Simd::larger(count.sums[s], Floats(1.0F));
        for (std::size_t c = 0; c < kChannels; ++c) {
            sums[s].colors[c] = colors[c].sums[s];
        }
        for (std::size_t pair = 0; pair < products.size(); ++pair) {
            sums[s].products[pair] = products[pair].sums[s];
        }
    }
    return sums;
}

/// Returns a line for each subset: the shortest part of its principal axis that contains the
/// projections of all its colors. Lines are relative to the color of texel 0.
template <class Simd, std::size_t kSubsets, std::size_t kChannels>
FOAM_INLINE KernelArray<LineOf<Simd, kChannels>, kSubsets> principal_lines(
    const ColorLanes<Simd, kChannels>& relative_colors,
    const KernelArray<ColorSums<Simd, kChannels>, kSubsets>& sums,
    const Membership<Simd, kSubsets>& membership) {
    using Floats = typename Simd::Floats;
    KernelArray<ColorOf<Simd, kChannels>, kSubsets> means;
    KernelArray<KernelArray<Floats, kSubsets>, kChannels> axes;
    KernelArray<Floats, kSubsets> centers;  // the positions of the means along the axes
    KernelArray<Floats, kSubsets> squares;
    for (std::size_t s = 0; s < kSubsets; ++s) {
        const Floats share = Floats(1.0F) / sums[s].count;
        for (std::size_t c = 0; c < kChannels; ++c) {
            means[s][c] = sums[s].colors[c] * share;
        }
        const auto axis =
            principal_axis<Simd, kChannels>(scatter_of<Simd, kChannels>(sums[s], means[s]));
        squares[s] = 1e-20F;
        for (std::size_t c = 0; c < kChannels; ++c) {
            axes[c][s] = axis[c];
            squares[s] += axis[c] * axis[c];
            centers[s] += axis[c] * means[s][c];
        }
    }
    KernelArray<Floats, kSubsets> low;
    KernelArray<Floats, kSubsets> high;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        Floats along = Floats() - membership.select(centers, k);
        for (std::size_t c = 0; c < kChannels; ++c) {
            along += relative_colors[k][c] * membership.select(axes[c], k);
        }
        for (std::size_t s = 0; s < kSubsets; ++s) {
            // Texels of other subsets get the position 0. This is the position of the mean, so
            // these texels change neither low[s] nor high[s].
            const Floats position =
                kSubsets == 1 ? along : Simd::select(membership.masks[s][k], along, Floats());
            low[s] = Simd::smaller(low[s], position);
            high[s] = Simd::larger(high[s], position);
        }
    }
    KernelArray<LineOf<Simd, kChannels>, kSubsets> lines;
    for (std::size_t s = 0; s < kSubsets; ++s) {
        const Floats to_low = low[s] / squares[s];
        const Floats to_high = high[s] / squares[s];
        for (std::size_t c = 0; c < kChannels; ++c) {
            lines[s][0][c] = means[s][c] + to_low * axes[c][s];
            lines[s][1][c] = means[s][c] + to_high * axes[c][s];
        }
    }
    return lines;
}

}  // namespace foam::texgen::bc7
