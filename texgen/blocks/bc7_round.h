// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/bc7_line.h"
#include "texgen/blocks/bc7_modes.h"

#include <cstddef>

// Rounds the endpoints of a subset to values that a mode of BC7 can store, for several blocks at
// once. Both endpoints are rounded together: each may be rounded down or up, and the pair of values
// with the smallest error is used. A mode stores each channel of an endpoint as a code of a few
// bits. In some modes a lowest bit, which all channels of the endpoint share, follows the code
// (LowestBits).

namespace foam::texgen::bc7 {

/// The part of a mode that determines how colors are approximated.
template <std::size_t kSubsetCount,
          std::size_t kChannelCount,
          int kCodeBits,
          LowestBits kLowestBits,
          int kBitsOfIndex>
struct Format {
    static constexpr std::size_t kSubsets = kSubsetCount;
    static constexpr std::size_t kChannels = kChannelCount;
    static constexpr LowestBits kLowest = kLowestBits;
    static constexpr int kMaxCode = (1 << kCodeBits) - 1;
    /// The number of bits per channel of an endpoint, including the lowest bit.
    static constexpr int kBits = kCodeBits + (kLowestBits == LowestBits::None ? 0 : 1);
    static constexpr int kSteps = (1 << kBitsOfIndex) - 1;  // from one endpoint to the other
};

/// The squared error of a subset whose texels have given indices, as a function of its endpoints.
/// At the two endpoints, channel c has the values x and y. Apart from a constant, the error of this
/// channel is
///     first x^2 + 2 mixed x y + second y^2 - 2 sums[0][c] x - 2 sums[1][c] y
template <class Simd, std::size_t kChannels>
struct SquaredError {
    using Floats = typename Simd::Floats;

    Floats first;
    Floats mixed;
    Floats second;
    LineOf<Simd, kChannels> sums;
};

/// Returns the value of 8 bits that a code and a lowest bit stand for.
template <class Format, class Simd>
FOAM_INLINE typename Simd::Floats value_of(const typename Simd::Ints& code,
                                           const typename Simd::Ints& lowest) {
    using Ints = typename Simd::Ints;
    const Ints bits = Format::kLowest == LowestBits::None ? code : (code << 1) + lowest;
    const Ints high = bits << (8 - Format::kBits);
    return Simd::numbers(high | (high >> Format::kBits));
}

/// Returns the code that, together with a lowest bit, stands for a value. The code is not rounded
/// to an integer. It is clamped to the range from 0 to `largest`.
template <class Format, class Simd>
FOAM_INLINE typename Simd::Floats code_of(const typename Simd::Floats& value,
                                          const typename Simd::Ints& lowest,
                                          float largest) {
    using Floats = typename Simd::Floats;
    constexpr float kStep = Format::kLowest == LowestBits::None ? 1.0F : 0.5F;
    constexpr float kScale = static_cast<float>((1 << Format::kBits) - 1) / 255.0F * kStep;
    Floats code = value * Floats(kScale);
    if constexpr (Format::kLowest != LowestBits::None) {
        code = code - Simd::numbers(lowest) * Floats(kStep);
    }
    return Simd::smaller(Simd::larger(code, Floats()), Floats(largest));
}

/// Rounds both endpoints of a channel, each down or up, to values of the format with given lowest
/// bits. Chooses the pair of values with the smallest squared error. If the error does not depend
/// on an endpoint, this endpoint is rounded to the nearest value. Returns the increase of the
/// squared error by the rounding. Precondition: `line` has the smallest squared error of all lines.
/// The increase is then a quadratic form in the differences between the rounded values and the ends
/// of `line`, without linear terms.
template <class Format, class Simd>
FOAM_INLINE typename Simd::Floats round_channel(std::size_t c,
                                                const LineOf<Simd, Format::kChannels>& line,
                                                const SquaredError<Simd, Format::kChannels>& error,
                                                const KernelArray<typename Simd::Ints, 2>& lowest,
                                                LineOf<Simd, Format::kChannels>& rounded) {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    KernelArray<KernelArray<Floats, 2>, 2> values;
    KernelArray<KernelArray<Floats, 2>, 2> differences;
    for (std::size_t end = 0; end < 2; ++end) {
        // The last argument of code_of ensures that `below` + 1 is a valid code. The two codes are
        // `below` and `below` + 1; the code that is nearer to the unrounded code is first.
        const Floats code =
            code_of<Format, Simd>(line[end][c], lowest[end], Format::kMaxCode - 0.5F);
        const Ints below = Simd::whole(code);
        const Ints nearest = Simd::whole(code + Floats(0.5F));
        const KernelArray<Ints, 2> codes = {nearest, below + below + Ints(1) - nearest};
        for (std::size_t k = 0; k < 2; ++k) {
            values[end][k] = value_of<Format, Simd>(codes[k], lowest[end]);
            differences[end][k] = values[end][k] - line[end][c];
        }
    }
    Floats smallest = 1e30F;
    for (unsigned k = 0; k < 4; ++k) {
        const Floats& x = differences[0][k & 1U];
        const Floats& y = differences[1][k >> 1U];
        const Floats found =
            x * (x * error.first + y * (error.mixed + error.mixed)) + y * y * error.second;
        const Ints is_better = Simd::less(found, smallest);
        smallest = Simd::smaller(found, smallest);
        rounded[0][c] = Simd::select(is_better, values[0][k & 1U], rounded[0][c]);
        rounded[1][c] = Simd::select(is_better, values[1][k >> 1U], rounded[1][c]);
    }
    return smallest;
}

/// Rounds both ends of a line to values of the format. Tries all lowest bits that the format allows
/// and uses those with the smallest squared error. Precondition: as in round_channel.
template <class Format, class Simd>
FOAM_INLINE void round_ends(const LineOf<Simd, Format::kChannels>& line,
                            const SquaredError<Simd, Format::kChannels>& error,
                            LineOf<Simd, Format::kChannels>& rounded) {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    // `bits` is a pair of lowest bits: bit 0 belongs to the first end, bit 1 to the second end. If
    // both lowest bits must be equal, only 0 and 3 are tried.
    constexpr int kFirst = Format::kLowest == LowestBits::Ones ? 3 : 0;
    constexpr int kLast = Format::kLowest == LowestBits::None ? 0 : 3;
    constexpr int kStride = Format::kLowest == LowestBits::PerSubset ? 3 : 1;
    Floats smallest = 1e30F;
#pragma GCC unroll 1
    for (int bits = kFirst; bits <= kLast; bits += kStride) {
        const KernelArray<Ints, 2> lowest = {Ints(bits & 1), Ints(bits >> 1)};
        LineOf<Simd, Format::kChannels> trial;
        Floats found;
        for (std::size_t c = 0; c < Format::kChannels; ++c) {
            found += round_channel<Format, Simd>(c, line, error, lowest, trial);
        }
        const Ints is_better = Simd::less(found, smallest);
        smallest = Simd::smaller(found, smallest);
        for (std::size_t c = 0; c < Format::kChannels; ++c) {
            rounded[0][c] = Simd::select(is_better, trial[0][c], rounded[0][c]);
            rounded[1][c] = Simd::select(is_better, trial[1][c], rounded[1][c]);
        }
    }
}

}  // namespace foam::texgen::bc7
