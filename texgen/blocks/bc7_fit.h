// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/bc7_line.h"
#include "texgen/blocks/bc7_round.h"

#include <cstddef>
#include <utility>

// Approximates the colors of blocks in a mode of BC7, for several blocks at once. The initial
// endpoints are the ends of the principal axes of the subsets, or lie beyond them (Fitter::start).
// Every texel gets the index of the nearest color between the endpoints. For these indices, the
// endpoints are then improved by least squares, as in S. Brown's "DXT compression techniques"
// (2006).

namespace foam::texgen::bc7 {

/// An approximation of several blocks in a mode: the partition, the endpoints of all subsets, an
/// index for each texel, and the sum of squared errors. The endpoints are expanded to 8 bits, as a
/// decoder expands them.
template <class Simd, class Format>
struct Fit {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    static constexpr std::size_t kChannels = Format::kChannels;

    /// Takes over the other fit in the lanes in which the other fit has a smaller error.
    FOAM_INLINE void improve(const Fit& other) {
        const Ints is_better = Simd::less(other.error, error);
        error = Simd::smaller(other.error, error);
        partition = Simd::select(is_better, other.partition, partition);
        for (std::size_t k = 0; k < indices.size(); ++k) {
            indices[k] = Simd::select(is_better, other.indices[k], indices[k]);
        }
        for (std::size_t s = 0; s < Format::kSubsets; ++s) {
            for (std::size_t end = 0; end < 2; ++end) {
                for (std::size_t c = 0; c < kChannels; ++c) {
                    ends[s][end][c] =
                        Simd::select(is_better, other.ends[s][end][c], ends[s][end][c]);
                }
            }
        }
    }

    Ints partition;
    KernelArray<LineOf<Simd, kChannels>, Format::kSubsets> ends;
    KernelArray<Ints, kBlockTexels> indices;
    Floats error = 1e30F;
};

/// Replaces a line by the line with the smallest squared error. In lanes in which the error does
/// not determine this line, keeps the given line.
template <class Simd, std::size_t kChannels>
FOAM_INLINE void improve_line(const SquaredError<Simd, kChannels>& error,
                              LineOf<Simd, kChannels>& line) {
    using Floats = typename Simd::Floats;
    const Floats determinant = error.first * error.second - error.mixed * error.mixed;
    const auto is_determined = Simd::less(Floats(1e-3F), determinant);
    const Floats inverse = Floats(1.0F) / Simd::select(is_determined, determinant, Floats(1.0F));
    for (std::size_t c = 0; c < kChannels; ++c) {
        const Floats low =
            (error.second * error.sums[0][c] - error.mixed * error.sums[1][c]) * inverse;
        const Floats high =
            (error.first * error.sums[1][c] - error.mixed * error.sums[0][c]) * inverse;
        line[0][c] = Simd::select(is_determined, low, line[0][c]);
        line[1][c] = Simd::select(is_determined, high, line[1][c]);
    }
}

/// Approximates the colors of blocks whose subsets are given.
template <class Format, class Simd>
class Fitter {
  public:
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    static constexpr std::size_t kSubsets = Format::kSubsets;
    static constexpr std::size_t kChannels = Format::kChannels;
    using Colors = ColorLanes<Simd, kChannels>;
    using Result = Fit<Simd, Format>;
    using Lines = KernelArray<LineOf<Simd, kChannels>, kSubsets>;

    /// Starts with the principal axes of the subsets. The colors and the membership must outlive
    /// the object.
    FOAM_INLINE Fitter(const Colors& colors,
                       const Membership<Simd, kSubsets>& membership,
                       const Ints& partition)
        : colors_(colors), membership_(membership), partition_(partition) {
        const Colors differences = relative<Simd, kChannels>(colors);
        const auto sums = subset_sums<Simd, kSubsets, kChannels>(differences, membership);
        lines_ = principal_lines<Simd, kSubsets, kChannels>(differences, sums, membership);
        for (std::size_t s = 0; s < kSubsets; ++s) {
            counts_[s] = sums[s].count;
            for (std::size_t c = 0; c < kChannels; ++c) {
                sums_[s][c] = sums[s].colors[c] + sums[s].count * colors[0][c];
                lines_[s][0][c] += colors[0][c];
                lines_[s][1][c] += colors[0][c];
            }
        }
        axes_ = lines_;
        start(0, 0);
    }

    /// Starts again with the principal axes. They are extended beyond the colors, so that no color
    /// gets one of the `low` smallest or the `high` largest indices. Least squares finds the best
    /// endpoints only for given indices, and other starts lead to other indices.
    FOAM_INLINE void start(int low, int high) {
        const Floats stride = Floats(1.0F / (kSteps - static_cast<float>(low + high)));
        const Floats before = stride * Floats(static_cast<float>(low));
        const Floats after = stride * Floats(static_cast<float>(high));
        for (std::size_t s = 0; s < kSubsets; ++s) {
            for (std::size_t c = 0; c < kChannels; ++c) {
                const Floats length = axes_[s][1][c] - axes_[s][0][c];
                lines_[s][0][c] = axes_[s][0][c] - length * before;
                lines_[s][1][c] = axes_[s][1][c] + length * after;
            }
        }
        Result unrounded;
        unrounded.ends = lines_;
        choose_indices(unrounded);
    }

    /// Repeats the following steps `rounds` times:
    /// - improves the endpoints by least squares
    /// - rounds the endpoints to values of the format
    /// - chooses indices
    /// - takes over the result in the lanes of `best` in which the result has the smaller error
    FOAM_INLINE void refine(int rounds, Result& best) {
#pragma GCC unroll 1
        for (int round = 0; round < rounds; ++round) {
            Result trial;
            trial.partition = partition_;
            for (std::size_t s = 0; s < kSubsets; ++s) {
                improve_line<Simd, kChannels>(errors_[s], lines_[s]);
                round_ends<Format, Simd>(lines_[s], errors_[s], trial.ends[s]);
            }
            choose_indices(trial);
            best.improve(trial);
        }
    }

  private:
    static constexpr auto kSteps = static_cast<float>(Format::kSteps);

    // Numbers that two computations need: the position of a texel along the line of its subset, and
    // the color that the index of the texel selects.
    struct Positions {
        KernelArray<KernelArray<Floats, kSubsets>, kChannels>
            origins;  // first endpoint plus 1/2, for rounding
        KernelArray<KernelArray<Floats, kSubsets>, kChannels>
            strides;  // change of color per 1/64 of weight
        // The position of a texel is scales[s] times the dot product of its color and the strides,
        // plus offsets[s]. The index of the texel is the integer part of the clamped position.
        KernelArray<Floats, kSubsets> scales;
        KernelArray<Floats, kSubsets> offsets;
    };

    FOAM_INLINE static Positions positions_of(const Result& fit) {
        Positions positions;
        for (std::size_t s = 0; s < kSubsets; ++s) {
            Floats square = 1e-9F;
            Floats offset;
            for (std::size_t c = 0; c < kChannels; ++c) {
                const Floats stride =
                    (fit.ends[s][1][c] - fit.ends[s][0][c]) * Floats(1.0F / 64.0F);
                positions.origins[c][s] = fit.ends[s][0][c] + Floats(0.5F);
                positions.strides[c][s] = stride;
                square += stride * stride;
                offset += fit.ends[s][0][c] * stride;
            }
            positions.scales[s] = Floats(kSteps / 64.0F) / square;
            positions.offsets[s] = Floats(0.5F) - offset * positions.scales[s];
        }
        return positions;
    }

    /// Chooses the index of the nearest color for every texel. Sets the indices and the error of
    /// the fit. Also sets errors_: for these indices, the squared errors as functions of the
    /// endpoints. The weights of the indices are nearly evenly spaced, so the index follows from
    /// the position along the line.
    FOAM_INLINE void choose_indices(Result& fit) {
        const Positions positions = positions_of(fit);
        SubsetSum<Simd, kSubsets> weights;
        SubsetSum<Simd, kSubsets> squares;
        KernelArray<SubsetSum<Simd, kSubsets>, kChannels> products;
        fit.error = Floats();
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            KernelArray<Floats, kChannels> stride;
            Floats along;
            for (std::size_t c = 0; c < kChannels; ++c) {
                stride[c] = membership_.select(positions.strides[c], k);
                along += colors_[k][c] * stride[c];
            }
            const Floats position = along * membership_.select(positions.scales, k) +
                                    membership_.select(positions.offsets, k);
            fit.indices[k] =
                Simd::whole(Simd::smaller(Simd::larger(position, Floats()), Floats(kSteps + 0.5F)));
            const Floats weight = Simd::truncated(
                Simd::numbers(fit.indices[k]) * Floats(64.0F / kSteps) + Floats(0.5F));
            for (std::size_t c = 0; c < kChannels; ++c) {
                const Floats decoded = Simd::truncated(membership_.select(positions.origins[c], k) +
                                                       weight * stride[c]);
                const Floats difference = decoded - colors_[k][c];
                fit.error += difference * difference;
                products[c].add(weight * colors_[k][c], membership_, k);
            }
            weights.add(weight, membership_, k);
            squares.add(weight * weight, membership_, k);
        }
        weights.finish();
        squares.finish();
        for (auto& product : products) {
            product.finish();
        }
        for (std::size_t s = 0; s < kSubsets; ++s) {
            const Floats sum = weights.sums[s] * Floats(1.0F / 64.0F);
            SquaredError<Simd, kChannels>& error = errors_[s];
            error.second = squares.sums[s] * Floats(1.0F / 4096.0F);
            error.mixed = sum - error.second;
            error.first = counts_[s] - sum - error.mixed;
            for (std::size_t c = 0; c < kChannels; ++c) {
                error.sums[1][c] = products[c].sums[s] * Floats(1.0F / 64.0F);
                error.sums[0][c] = sums_[s][c] - error.sums[1][c];
            }
        }
    }

    const Colors& colors_;
    const Membership<Simd, kSubsets>& membership_;
    Ints partition_;
    KernelArray<Floats, kSubsets> counts_;                  // numbers of texels
    KernelArray<ColorOf<Simd, kChannels>, kSubsets> sums_;  // sums of colors
    Lines axes_;                                            // the principal axes
    Lines lines_;
    KernelArray<SquaredError<Simd, kChannels>, kSubsets> errors_;
};

inline constexpr int kImprovements = 2;  // number of rounds of Fitter::refine

/// The growth of the squared error if the colors of a subset are rounded to the evenly spaced
/// colors of a line. It is given as a share of the spread of the colors along the line
/// (bc7_partition.h).
template <class Format>
inline constexpr float kRoundingShare = 1.0F / static_cast<float>(Format::kSteps* Format::kSteps);

/// Returns a fit in which all texels of a block are in one subset.
template <class Format, class Simd>
FOAM_INLINE Fit<Simd, Format> fit_line(const ColorLanes<Simd, Format::kChannels>& colors) {
    const Membership<Simd, 1> all;
    Fit<Simd, Format> fit;
    Fitter<Format, Simd>(colors, all, 0).refine(kImprovements, fit);
    return fit;
}

}  // namespace foam::texgen::bc7
