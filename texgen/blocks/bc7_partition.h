// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/bc7_line.h"
#include "texgen/blocks/bc7_modes.h"

#include <bit>
#include <cstddef>
#include <cstdint>

// A partition divides the texels of a block into subsets; BC7 approximates the colors of each
// subset by colors on a line of its own. The functions below estimate the sum of the squared errors
// for all partitions. The line of a subset is taken to be the principal axis of its colors. The
// squared distances of the colors from this axis add up to the trace of the scatter matrix minus
// the largest eigenvalue of this matrix. Rounding the colors to n steps along the axis adds this
// eigenvalue divided by n^2. The reason: evenly spaced colors between two endpoints at the distance
// L have the variance L^2 / 12. Rounding to n steps has the mean squared error (L / n)^2 / 12.
//
// The largest eigenvalue is estimated by the Frobenius norm of the matrix, which is the root of the
// sum of the squares of all eigenvalues. The estimate is good if one eigenvalue is much larger than
// the others.

namespace foam::texgen::bc7 {

/// The spread of the colors of all subsets of a partition. `along` is the sum of the largest
/// eigenvalues of the scatter matrices of the subsets, `across` the sum of all other eigenvalues.
template <class Simd>
struct Spread {
    typename Simd::Floats along;
    typename Simd::Floats across;
};

template <class Simd, std::size_t kChannels>
FOAM_INLINE void add_spread(const ColorSums<Simd, kChannels>& sums, Spread<Simd>& spread) {
    using Floats = typename Simd::Floats;
    const Floats share = Floats(1.0F) / sums.count;
    ColorOf<Simd, kChannels> mean;
    for (std::size_t c = 0; c < kChannels; ++c) {
        mean[c] = sums.colors[c] * share;
    }
    const Scatter<Simd, kChannels> scatter = scatter_of<Simd, kChannels>(sums, mean);
    Floats trace;
    Floats squares;
    Floats mixed;
    for (std::size_t c = 0; c < kChannels; ++c) {
        trace += scatter[c][c];
        squares += scatter[c][c] * scatter[c][c];
        for (std::size_t d = c + 1; d < kChannels; ++d) {
            mixed += scatter[c][d] * scatter[c][d];
        }
    }
    const Floats along = Simd::square_root(squares + mixed + mixed);
    spread.along += along;
    spread.across += trace - along;
}

/// For each of several blocks, the partitions with the smallest estimated errors, the best one
/// first.
template <class Simd>
struct BestPartitions {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    static constexpr std::size_t kMaxCount = 8;

    /// Keeps at most `given` partitions. Precondition: `given` is at most kMaxCount.
    FOAM_INLINE explicit BestPartitions(std::size_t given) : count(given) {
        for (Floats& error : errors) {
            error = 1e30F;
        }
    }

    FOAM_INLINE void insert(Floats error, Ints partition) {
#pragma GCC unroll 1
        for (std::size_t k = 0; k < count; ++k) {
            const Ints is_better = Simd::less(error, errors[k]);
            const Floats worse = Simd::larger(error, errors[k]);
            const Ints other = Simd::select(is_better, partitions[k], partition);
            errors[k] = Simd::smaller(error, errors[k]);
            partitions[k] = Simd::select(is_better, partition, partitions[k]);
            error = worse;
            partition = other;
        }
    }

    std::size_t count;
    KernelArray<Floats, kMaxCount> errors;  // estimates
    KernelArray<Ints, kMaxCount> partitions;
};

/// For each texel, the sums of a subset that contains only this texel.
template <class Simd, std::size_t kChannels>
using TexelSums = KernelArray<ColorSums<Simd, kChannels>, kBlockTexels>;

/// Adds up the terms of the texels of a subset. Bit k of the mask is set if texel k is a member.
template <class Simd, std::size_t kChannels>
FOAM_INLINE ColorSums<Simd, kChannels> sums_over(const TexelSums<Simd, kChannels>& terms,
                                                 unsigned mask) {
    ColorSums<Simd, kChannels> sums;
    for (unsigned rest = mask; rest != 0; rest &= rest - 1) {
        sums.add(terms[static_cast<std::size_t>(std::countr_zero(rest))]);
    }
    return sums;
}

/// Returns the texels of a subset as bits: bit k is set if texel k is a member.
constexpr std::uint16_t mask_of(int subsets, int partition, int subset) {
    unsigned mask = 0;
    for (int k = 0; k < kBlockTexels; ++k) {
        mask |= subset_of(subsets, partition, k) == subset ? 1U << k : 0U;
    }
    return static_cast<std::uint16_t>(mask);
}

/// All subsets except the first of every partition into kSubsets subsets, as bits (mask_of).
template <std::size_t kSubsets>
inline constexpr auto kSubsetMasks = [] {
    KernelArray<KernelArray<std::uint16_t, kSubsets - 1>, kPartitions> masks{};
    for (int partition = 0; partition < kPartitions; ++partition) {
        for (int s = 1; s < static_cast<int>(kSubsets); ++s) {
            masks[static_cast<std::size_t>(partition)][static_cast<std::size_t>(s) - 1] =
                mask_of(static_cast<int>(kSubsets), partition, s);
        }
    }
    return masks;
}();

/// Calls insert(partition, spread) for all partitions into the given number of subsets.
template <class Simd, std::size_t kSubsets, std::size_t kChannels, class Insert>
FOAM_INLINE void for_partitions(const ColorLanes<Simd, kChannels>& relative_colors,
                                const Insert& insert) {
    TexelSums<Simd, kChannels> terms;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        terms[k] = sums_of<Simd, kChannels>(relative_colors[k]);
    }
    const ColorSums<Simd, kChannels> all = sums_over<Simd, kChannels>(terms, 0xffff);
    for (int partition = 0; partition < kPartitions; ++partition) {
        Spread<Simd> spread;
        ColorSums<Simd, kChannels> rest = all;
        for (const std::uint16_t mask :
             kSubsetMasks<kSubsets>[static_cast<std::size_t>(partition)]) {
            const ColorSums<Simd, kChannels> sums = sums_over<Simd, kChannels>(terms, mask);
            rest = rest.without(sums);
            add_spread<Simd, kChannels>(sums, spread);
        }
        add_spread<Simd, kChannels>(rest, spread);
        insert(partition, spread);
    }
}

/// Returns the subsets of the texels of several blocks. `partitions` has the partition of each
/// block.
template <class Simd, std::size_t kSubsets>
FOAM_INLINE Membership<Simd, kSubsets> membership_of(const typename Simd::Ints& partitions) {
    using Ints = typename Simd::Ints;
    Membership<Simd, kSubsets> membership;
    if constexpr (kSubsets > 1) {
        KernelArray<std::int32_t, Simd::kCount> bits;
        partitions.store(bits.data());
        for (std::int32_t& number : bits) {
            const auto partition = static_cast<std::size_t>(number);
            number = kSubsets == 2 ? static_cast<std::int32_t>(kPartitionMasks[partition])
                                   : static_cast<std::int32_t>(kThreeSubsets[partition]);
        }
        constexpr int kBits = kSubsets == 2 ? 1 : 2;
        const auto loaded = Ints::load(bits.data());
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            const Ints subset = (loaded >> (kBits * static_cast<int>(k))) & Ints((1 << kBits) - 1);
            for (std::size_t s = 0; s < kSubsets; ++s) {
                membership.masks[s][k] = Simd::equal(subset, Ints(static_cast<std::int32_t>(s)));
            }
        }
    }
    return membership;
}

}  // namespace foam::texgen::bc7
