// SPDX-License-Identifier: Apache-2.0

#include "core/parallel/kernel_array.h"
#include "core/parallel/simd_level.h"
#include "texgen/blocks/bc7.h"
#include "texgen/blocks/bc7_fit.h"
#include "texgen/blocks/bc7_group.h"
#include "texgen/blocks/bc7_modes.h"
#include "texgen/blocks/bc7_own_indices.h"
#include "texgen/blocks/bc7_pack.h"
#include "texgen/blocks/bc7_partition.h"
#include "texgen/blocks/lanes.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

// Blocks of a single color are stored exactly, in mode 5. All other blocks are compressed in
// groups, one block per lane of a SIMD register. They are first stored in mode 6, which
// approximates the colors of a block by a line between two colors. Blocks that a line approximates
// badly are collected in new groups, which are then tried in other modes.

namespace foam::texgen {

namespace {

using namespace bc7;  // NOLINT(google-build-using-namespace): the parts of the encoder

// Limits for the sum of squared errors of a block. A block above kGoodEnough is tried in modes
// other than mode 6. If an opaque block is then still above kBad, it is also tried in the modes of
// three subsets. In the modes 1 and 3, it is tried with more partitions.
constexpr float kGoodEnough = 8.0F;
constexpr float kBad = 40.0F;

using OpaqueMode6 = Format<1, 3, 7, LowestBits::Ones, 4>;
using Mode6 = Format<1, 4, 7, LowestBits::PerEndpoint, 4>;
using Mode0 = Format<3, 3, 4, LowestBits::PerEndpoint, 3>;
using Mode1 = Format<2, 3, 6, LowestBits::PerSubset, 3>;
using Mode2 = Format<3, 3, 5, LowestBits::None, 2>;
using Mode3 = Format<2, 3, 7, LowestBits::PerEndpoint, 2>;
using Mode7 = Format<2, 4, 5, LowestBits::PerEndpoint, 2>;
// kTried0 is the number of partitions that are tried in mode 0, and so on. kMoreTried1 and
// kMoreTried3 replace kTried1 and kTried3 for blocks above kBad.
constexpr std::size_t kTried0 = 3;
constexpr std::size_t kTried1 = 2;
constexpr std::size_t kTried2 = 3;
constexpr std::size_t kTried3 = 2;
constexpr std::size_t kTried7 = 4;
constexpr std::size_t kMoreTried1 = 6;
constexpr std::size_t kMoreTried3 = 4;

// Two endpoints for every value of 8 bits. The endpoints are codes of 7 bits, expanded to 8 bits.
// Interpolation between them with the weight 21 / 64 gives the value.
using ExactEnds = KernelArray<KernelArray<int, 2>, 256>;

constexpr ExactEnds make_exact_ends() {
    ExactEnds ends{};
    for (int first = 127; first >= 0; --first) {
        for (int second = std::min(first + 3, 127); second >= first; --second) {
            const int value = interpolated(expanded(first, 7), expanded(second, 7), 21);
            ends[static_cast<std::size_t>(value)] = {expanded(first, 7), expanded(second, 7)};
        }
    }
    return ends;
}

constexpr ExactEnds kExactEnds = make_exact_ends();

// Returns a block that stores a single color exactly, in mode 5 with the color index 1 for all
// texels.
Bc7Block solid_block(const std::array<std::uint8_t, 4>& color) {
    BlockFields fields{.mode = 5};
    for (std::size_t end = 0; end < 2; ++end) {
        for (std::size_t c = 0; c < 3; ++c) {
            fields.ends[0][end][c] = kExactEnds[color[c]][end];
        }
        fields.ends[0][end][3] = color[3];
    }
    fields.indices.fill(1);
    return pack_bc7(fields);
}

bool is_solid(const TexelBlock& texels) {
    return std::ranges::all_of(texels, [&](const auto& texel) { return texel == texels.front(); });
}

bool is_opaque(const TexelBlock& texels) {
    return std::ranges::all_of(texels, [](const auto& texel) { return texel[3] == 255; });
}

constexpr KernelArray<std::size_t, 3> kRgb = {0, 1, 2};
constexpr KernelArray<std::size_t, 4> kRgba = {0, 1, 2, 3};

// Tries mode 6.
template <class Format, std::size_t kChannels, class Simd>
FOAM_INLINE void try_line(Group<Simd> group, const KernelArray<std::size_t, kChannels>& channels) {
    const auto fit = fit_line<Format, Simd>(group.colors(channels));
    const StoredFit<Simd, Format> stored(fit);
    group.offer(fit.error, [&](std::size_t lane) { return stored.fields(6, lane); });
}

// Estimates the squared error of a partition in a mode: the squared distances of the colors from
// the lines, and the rounding errors along the lines (kRoundingShare).
template <class Format, class Simd>
FOAM_INLINE typename Simd::Floats estimated_error(const Spread<Simd>& spread) {
    return spread.across + spread.along * kRoundingShare<Format>;
}

// Tries the given partitions in a mode of several subsets. Then tries the best of them again with
// other initial endpoints (Fitter::start).
template <class Format, class Simd>
FOAM_INLINE void try_partitions(Group<Simd>& group,
                                const ColorLanes<Simd, Format::kChannels>& colors,
                                const BestPartitions<Simd>& partitions,
                                int mode) {
    Fit<Simd, Format> best;
#pragma GCC unroll 1
    for (std::size_t k = 0; k <= partitions.count; ++k) {
        const bool is_last = k == partitions.count;
        const typename Simd::Ints partition = is_last ? best.partition : partitions.partitions[k];
        const auto membership = membership_of<Simd, Format::kSubsets>(partition);
        Fitter<Format, Simd> fitter(colors, membership, partition);
        if (!is_last) {
            fitter.refine(1, best);
            continue;
        }
#pragma GCC unroll 1
        for (int low = 0; low < 2; ++low) {
            fitter.start(low, 1 - low);
            fitter.refine(kImprovements, best);
        }
    }
    const StoredFit<Simd, Format> stored(best);
    group.offer(best.error, [&](std::size_t lane) { return stored.fields(mode, lane); });
}

// Tries opaque blocks in the modes 1 and 3, which have two subsets, and in mode 5.
struct TwoLines {
    std::size_t mode1_count;  // number of partitions to try in mode 1
    std::size_t mode3_count;  // number of partitions to try in mode 3

    template <class Simd>
    FOAM_INLINE void operator()(Group<Simd> group) const {
        const auto colors = group.colors(kRgb);
        BestPartitions<Simd> mode1_partitions(mode1_count);
        BestPartitions<Simd> mode3_partitions(mode3_count);
        for_partitions<Simd, 2, 3>(
            relative<Simd, 3>(colors),
            [&](int partition, const Spread<Simd>& spread) FOAM_INLINE_LAMBDA {
                mode1_partitions.insert(estimated_error<Mode1>(spread), partition);
                mode3_partitions.insert(estimated_error<Mode3>(spread), partition);
            });
        try_partitions<Mode1>(group, colors, mode1_partitions, 1);
        try_partitions<Mode3>(group, colors, mode3_partitions, 3);
        try_own_indices<Mode5, Simd, 3>(group, colors);
    }
};

// Tries opaque blocks in the modes 0 and 2, which have three subsets.
struct ThreeLines {
    template <class Simd>
    FOAM_INLINE void operator()(Group<Simd> group) const {
        constexpr int kPartitionsOfMode0 = 16;
        const auto colors = group.colors(kRgb);
        BestPartitions<Simd> mode0_partitions(kTried0);
        BestPartitions<Simd> mode2_partitions(kTried2);
        for_partitions<Simd, 3, 3>(
            relative<Simd, 3>(colors),
            [&](int partition, const Spread<Simd>& spread) FOAM_INLINE_LAMBDA {
                if (partition < kPartitionsOfMode0) {
                    mode0_partitions.insert(estimated_error<Mode0>(spread), partition);
                }
                mode2_partitions.insert(estimated_error<Mode2>(spread), partition);
            });
        try_partitions<Mode0>(group, colors, mode0_partitions, 0);
        try_partitions<Mode2>(group, colors, mode2_partitions, 2);
    }
};

// Tries blocks that are not opaque in the modes 4, 5 and 7.
struct TransparentModes {
    template <class Simd>
    FOAM_INLINE void operator()(Group<Simd> group) const {
        const auto colors = group.colors(kRgba);
        BestPartitions<Simd> mode7_partitions(kTried7);
        for_partitions<Simd, 2, 4>(
            relative<Simd, 4>(colors),
            [&](int partition, const Spread<Simd>& spread) FOAM_INLINE_LAMBDA {
                mode7_partitions.insert(estimated_error<Mode7>(spread), partition);
            });
        try_partitions<Mode7>(group, colors, mode7_partitions, 7);
        try_own_indices<Mode4, Simd, 4>(group, colors);
        try_own_indices<Mode4Exchanged, Simd, 4>(group, colors);
        try_own_indices<Mode5, Simd, 4>(group, colors);
    }
};

// Returns the blocks whose error is larger than a limit.
Numbers worse_than(float limit, const Work& work, Numbers numbers) {
    std::erase_if(numbers, [&](std::uint32_t number) { return work.errors[number] <= limit; });
    return numbers;
}

}  // namespace

void encode_bc7(std::span<const TexelBlock> texels, std::span<Bc7Block> blocks) {
    assert(texels.size() == blocks.size());
    Work work{
        texels, blocks, std::vector<float>(texels.size(), std::numeric_limits<float>::infinity())};
    Numbers opaque;
    Numbers others;
    for (std::size_t k = 0; k < texels.size(); ++k) {
        if (is_solid(texels[k])) {
            blocks[k] = solid_block(texels[k].front());
        } else {
            (is_opaque(texels[k]) ? opaque : others).push_back(static_cast<std::uint32_t>(k));
        }
    }
    encode_groups(
        work, opaque, [](auto group) FOAM_INLINE_LAMBDA { try_line<OpaqueMode6>(group, kRgb); });
    encode_groups(
        work, others, [](auto group) FOAM_INLINE_LAMBDA { try_line<Mode6>(group, kRgba); });
    encode_groups(work, worse_than(kGoodEnough, work, opaque), TwoLines{kTried1, kTried3});
    const Numbers bad = worse_than(kBad, work, opaque);
    encode_groups(work, bad, TwoLines{kMoreTried1, kMoreTried3});
    encode_groups(work, bad, ThreeLines());
    encode_groups(work, worse_than(kGoodEnough, work, others), TransparentModes());
}

}  // namespace foam::texgen
