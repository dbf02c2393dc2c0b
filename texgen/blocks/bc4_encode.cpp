// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/kernel_array.h"
#include "core/parallel/simd_level.h"
#include "texgen/blocks/bc4.h"
#include "texgen/blocks/bc4_palette.h"
#include "texgen/blocks/lanes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

// One channel of a block is approximated by evenly spaced values between two endpoints: eight, or
// six and in addition 0 and 255. At first the endpoints are the smallest and the largest texel (for
// six values, of the texels that are neither 0 nor 255). They are improved by least squares, and
// then moved by 1 where this reduces the error. Blocks are compressed in groups, one block per lane
// of a SIMD register.

namespace foam::texgen {

namespace {

constexpr int kLeastSquaresSteps = 2;
constexpr int kMovePasses = 2;  // each pass tries all moves of the endpoints
constexpr float kMaxTexel = 255.0F;

// The values of one channel of several blocks.
template <class Simd>
using Values = KernelArray<typename Simd::Floats, kBlockTexels>;

// The endpoints of several blocks, and the sums of the squared errors.
template <class Simd>
struct ChannelFit {
    using Floats = typename Simd::Floats;

    // Takes over the other fit in the lanes in which the other fit has a smaller error.
    FOAM_INLINE void improve(const ChannelFit& other) {
        const auto is_better = Simd::less(other.error, error);
        low = Simd::select(is_better, other.low, low);
        high = Simd::select(is_better, other.high, high);
        error = Simd::smaller(other.error, error);
    }

    Floats low;
    Floats high;
    Floats error = 1e30F;
};

// Returns a mask: -1 in the lanes in which the endpoints can be stored, 0 in all others. Eight
// values need low < high, six values only low <= high.
template <class Simd, int kSteps>
FOAM_INLINE typename Simd::Ints in_order(const ChannelFit<Simd>& fit) {
    return Simd::less(fit.low, kSteps == 7 ? fit.high : fit.high + typename Simd::Floats(0.5F));
}

// Sums over texels, from which least squares computes the endpoints. The weight of a texel is the
// index of its nearest value, from 0 to kSteps.
template <class Simd>
struct ChannelSums {
    typename Simd::Floats count;     // number of texels
    typename Simd::Floats weights;   // sum of the weights
    typename Simd::Floats squares;   // sum of the squares of the weights
    typename Simd::Floats values;    // sum of the texels
    typename Simd::Floats products;  // sum of the texels times their weights
};

// Finds the value of the palette (bc4_palette.h) that is nearest to each texel. Sets the error of
// the fit to the sum of the squared errors. Returns the sums over the texels whose nearest value is
// not one of the extra values 0 and 255.
template <class Simd, int kSteps>
FOAM_INLINE ChannelSums<Simd> measure(const Values<Simd>& texels, ChannelFit<Simd>& fit) {
    using Floats = typename Simd::Floats;
    const Palette<Simd, kSteps> palette(fit.low, fit.high);
    ChannelSums<Simd> sums;
    fit.error = Floats();
    for (const Floats& texel : texels) {
        const auto nearest = palette.nearest(texel);
        fit.error += nearest.square;
        const Floats one = Simd::select(nearest.is_between, Floats(1.0F), Floats());
        const Floats weight = nearest.index * one;
        sums.count += one;
        sums.weights += weight;
        sums.squares += weight * weight;
        sums.values += texel * one;
        sums.products += texel * weight;
    }
    return sums;
}

// Replaces the endpoints by those with the smallest squared error, if the sums determine them.
template <class Simd, int kSteps>
FOAM_INLINE void solve(const ChannelSums<Simd>& sums, ChannelFit<Simd>& fit) {
    using Floats = typename Simd::Floats;
    const Floats determinant = sums.count * sums.squares - sums.weights * sums.weights;
    const auto is_determined = Simd::less(Floats(0.5F), determinant);
    const Floats inverse = Floats(1.0F) / Simd::select(is_determined, determinant, Floats(1.0F));
    const Floats low = (sums.values * sums.squares - sums.products * sums.weights) * inverse;
    const Floats slope = (sums.count * sums.products - sums.weights * sums.values) * inverse;
    const auto rounded = [](const Floats& value) FOAM_INLINE_LAMBDA {
        return Simd::truncated(Simd::smaller(Simd::larger(value, Floats()), Floats(kMaxTexel)) +
                               Floats(0.5F));
    };
    fit.low = Simd::select(is_determined, rounded(low), fit.low);
    fit.high = Simd::select(is_determined, rounded(low + slope * Floats(kSteps)), fit.high);
}

// Adds `low` and `high` to the endpoints of a fit if the endpoints keep their order and stay in
// [0, 255], and if the error becomes smaller.
template <class Simd, int kSteps>
FOAM_INLINE void try_move(const Values<Simd>& texels, int low, int high, ChannelFit<Simd>& best) {
    using Floats = typename Simd::Floats;
    ChannelFit<Simd> moved;
    moved.low = best.low + Floats(static_cast<float>(low));
    moved.high = best.high + Floats(static_cast<float>(high));
    const auto is_valid = in_order<Simd, kSteps>(moved) & Simd::less(Floats(-0.5F), moved.low) &
                          Simd::less(moved.high, Floats(kMaxTexel + 0.5F));
    measure<Simd, kSteps>(texels, moved);
    moved.error = Simd::select(is_valid, moved.error, Floats(1e30F));
    best.improve(moved);
}

// Returns the best fit that is found from initial endpoints.
template <class Simd, int kSteps>
FOAM_INLINE ChannelFit<Simd> fitted(const Values<Simd>& texels,
                                    const typename Simd::Floats& low,
                                    const typename Simd::Floats& high) {
    using Floats = typename Simd::Floats;
    constexpr KernelArray<std::pair<int, int>, 6> kMoves = {
        {{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, -1}, {-1, 1}}};
    ChannelFit<Simd> best;
    ChannelFit<Simd> trial;
    trial.low = low;
    trial.high = high;
#pragma GCC unroll 1
    for (int round = 0; round <= kLeastSquaresSteps; ++round) {
        const ChannelSums<Simd> sums = measure<Simd, kSteps>(texels, trial);
        trial.error = Simd::select(in_order<Simd, kSteps>(trial), trial.error, Floats(1e30F));
        best.improve(trial);
        solve<Simd, kSteps>(sums, trial);
    }
#pragma GCC unroll 1
    for (int pass = 0; pass < kMovePasses; ++pass) {
#pragma GCC unroll 1
        for (const auto& [low_move, high_move] : kMoves) {
            try_move<Simd, kSteps>(texels, low_move, high_move, best);
        }
    }
    return best;
}

// The endpoints and the indices of blocks as they are stored: the indices of texels 0 to 7 and 8 to
// 15 have 24 bits each.
template <class Simd>
struct StoredChannels {
    using Ints = typename Simd::Ints;

    FOAM_INLINE void replace(const Ints& mask, const StoredChannels& other) {
        for (std::size_t k = 0; k < fields.size(); ++k) {
            fields[k] = Simd::select(mask, other.fields[k], fields[k]);
        }
    }

    KernelArray<Ints, 4> fields;  // the first and the second endpoint, the indices of both halves
};

template <class Simd, int kSteps>
FOAM_INLINE StoredChannels<Simd> stored(const Values<Simd>& texels, const ChannelFit<Simd>& fit) {
    using Ints = typename Simd::Ints;
    const Palette<Simd, kSteps> palette(fit.low, fit.high);
    const Ints low = Simd::whole(fit.low);
    const Ints high = Simd::whole(fit.high);
    StoredChannels<Simd> result;
    result.fields[0] = palette.kHasExtremes ? low : high;
    result.fields[1] = palette.kHasExtremes ? high : low;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        Ints& indices = result.fields[k < 8 ? 2 : 3];
        indices = indices | (palette.nearest(texels[k]).code << (3 * static_cast<int>(k % 8)));
    }
    return result;
}

// Compresses one channel of several blocks.
template <class Simd>
FOAM_INLINE StoredChannels<Simd> compressed(const Values<Simd>& texels) {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    Floats low = kMaxTexel;
    Floats high;
    Floats inner_low = kMaxTexel;  // the smallest texel that is not 0
    Floats inner_high;             // the largest texel that is not 255
    for (const Floats& texel : texels) {
        low = Simd::smaller(low, texel);
        high = Simd::larger(high, texel);
        inner_low = Simd::smaller(
            inner_low, Simd::select(Simd::less(Floats(), texel), texel, Floats(kMaxTexel)));
        inner_high = Simd::larger(
            inner_high, Simd::select(Simd::less(texel, Floats(kMaxTexel)), texel, Floats()));
    }
    const ChannelFit<Simd> eight = fitted<Simd, 7>(texels, low, high);
    StoredChannels<Simd> result = stored<Simd, 7>(texels, eight);
    const Ints has_extremes =
        Simd::less(low, Floats(0.5F)) | Simd::less(Floats(kMaxTexel - 0.5F), high);
    if (Simd::any(has_extremes)) {
        const ChannelFit<Simd> six = fitted<Simd, 5>(texels, inner_low, inner_high);
        result.replace(Simd::less(six.error, eight.error) & has_extremes,
                       stored<Simd, 5>(texels, six));
    }
    // Equal endpoints with the index 0 store a single value.
    StoredChannels<Simd> single;
    single.fields[0] = single.fields[1] = Simd::whole(low);
    result.replace(Simd::equal(low, high), single);
    return result;
}

// Returns one channel of as many blocks as there are lanes. If `texels` has fewer blocks, the last
// one is repeated.
template <class Simd>
FOAM_INLINE Values<Simd> channel_of(std::span<const TexelBlock> texels, std::size_t channel) {
    KernelArray<KernelArray<float, Simd::kCount>, kBlockTexels> numbers;
    for (std::size_t lane = 0; lane < Simd::kCount; ++lane) {
        const TexelBlock& block = texels[std::min(lane, texels.size() - 1)];
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            numbers[k][lane] = static_cast<float>(block[k][channel]);
        }
    }
    Values<Simd> values;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        values[k] = Simd::Floats::load(numbers[k].data());
    }
    return values;
}

// Stores the 8 bytes of a channel in each block, beginning at the byte `offset` of the block.
template <class Simd, std::size_t kBytes>
FOAM_INLINE void store(const StoredChannels<Simd>& channels,
                       std::size_t offset,
                       std::span<std::array<std::uint8_t, kBytes>> blocks) {
    KernelArray<KernelArray<std::int32_t, Simd::kCount>, 4> fields;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        channels.fields[k].store(fields[k].data());
    }
    for (std::size_t lane = 0; lane < blocks.size(); ++lane) {
        std::uint8_t* const to = blocks[lane].data() + offset;
        to[0] = static_cast<std::uint8_t>(fields[0][lane]);
        to[1] = static_cast<std::uint8_t>(fields[1][lane]);
        for (std::size_t byte = 0; byte < 6; ++byte) {
            to[2 + byte] =
                static_cast<std::uint8_t>(fields[byte < 3 ? 2 : 3][lane] >> (8 * (byte % 3)));
        }
    }
}

// Compresses one channel of all blocks. Its bytes begin at `offset` in each block.
template <std::size_t kBytes>
void encode_channel(std::span<const TexelBlock> texels,
                    std::size_t channel,
                    std::size_t offset,
                    std::span<std::array<std::uint8_t, kBytes>> blocks) {
    at_simd_level([=](auto level) FOAM_INLINE_LAMBDA {
        using Simd = LanesAt<decltype(level)::value>;
        for (std::size_t first = 0; first < texels.size(); first += Simd::kCount) {
            const std::size_t count = std::min(Simd::kCount, texels.size() - first);
            const Values<Simd> values = channel_of<Simd>(texels.subspan(first, count), channel);
            store<Simd, kBytes>(compressed<Simd>(values), offset, blocks.subspan(first, count));
        }
    });
}

}  // namespace

void encode_bc4(std::span<const TexelBlock> texels, std::span<Bc4Block> blocks) {
    assert(texels.size() == blocks.size());
    encode_channel(texels, 0, 0, blocks);
}

void encode_bc5(std::span<const TexelBlock> texels, std::span<Bc5Block> blocks) {
    assert(texels.size() == blocks.size());
    encode_channel(texels, 0, 0, blocks);
    encode_channel(texels, 1, kBc4Bytes, blocks);
}

}  // namespace foam::texgen
