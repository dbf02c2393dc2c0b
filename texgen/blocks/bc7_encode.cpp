// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7.h"
#include "texgen/blocks/bc7_fit.h"
#include "texgen/blocks/bc7_modes.h"
#include "texgen/blocks/bc7_partition.h"
#include "texgen/blocks/bit_stream.h"

#include <algorithm>
#include <limits>
#include <utility>

// A block in one line of colors is stored in mode 6. An opaque block that a line approximates badly
// is also tried in mode 1, which has a line for each of two subsets of the texels.

namespace foam::texgen {

namespace {

using namespace bc7;  // NOLINT(google-build-using-namespace): the facts about the modes

// The sum of squared errors of a block up to which mode 1 is not tried.
constexpr float kGoodEnough = 24.0F;

// Exchanges the endpoints if the highest bit of the index of the anchor texel is set, because this
// bit is not stored.
void order_ends(Fit& fit, Subset subset, int anchor, int last_index) {
    if (fit.indices[static_cast<std::size_t>(anchor)] * 2 <= last_index) {
        return;
    }
    std::swap(fit.ends.codes[0], fit.ends.codes[1]);
    std::swap(fit.ends.lowest[0], fit.ends.lowest[1]);
    for (int k = 0; k < kBlockTexels; ++k) {
        int& index = fit.indices[static_cast<std::size_t>(k)];
        index = has_texel(subset, k) ? last_index - index : index;
    }
}

using Block = std::array<std::uint8_t, kBc7Bytes>;

Block write_mode6(Fit fit) {
    order_ends(fit, kAllTexels, 0, 15);
    BitWriter bits;
    bits.write(1 << 6, 7);
    for (std::size_t c = 0; c < 4; ++c) {
        bits.write(fit.ends.codes[0][c], 7);
        bits.write(fit.ends.codes[1][c], 7);
    }
    bits.write(fit.ends.lowest[0], 1);
    bits.write(fit.ends.lowest[1], 1);
    for (std::size_t k = 0; k < fit.indices.size(); ++k) {
        bits.write(fit.indices[k], k == 0 ? 3 : 4);
    }
    return bits.bytes();
}

// A block in mode 1.
struct TwoLines {
    int partition = 0;
    std::array<Fit, 2> fits;

    float error() const { return fits[0].error + fits[1].error; }
};

Block write_mode1(TwoLines lines) {
    const auto partition = static_cast<std::size_t>(lines.partition);
    const Subset second = kPartitionMasks[partition];
    const int anchor = kSecondAnchors[partition];
    order_ends(lines.fits[0], kAllTexels & ~second, 0, 7);
    order_ends(lines.fits[1], second, anchor, 7);
    BitWriter bits;
    bits.write(1 << 1, 2);
    bits.write(lines.partition, 6);
    for (std::size_t c = 0; c < 3; ++c) {
        for (const Fit& fit : lines.fits) {
            bits.write(fit.ends.codes[0][c], 6);
            bits.write(fit.ends.codes[1][c], 6);
        }
    }
    bits.write(lines.fits[0].ends.lowest[0], 1);
    bits.write(lines.fits[1].ends.lowest[0], 1);
    for (int k = 0; k < kBlockTexels; ++k) {
        const Fit& fit = lines.fits[has_texel(second, k) ? 1 : 0];
        bits.write(fit.indices[static_cast<std::size_t>(k)], k == 0 || k == anchor ? 2 : 3);
    }
    return bits.bytes();
}

TwoLines fit_two_lines(const Colors& colors) {
    TwoLines best;
    for (const int partition : best_partitions(colors)) {
        const Subset second = kPartitionMasks[static_cast<std::size_t>(partition)];
        const Subset first = kAllTexels & ~second;
        const TwoLines lines{partition, {fit_mode1(colors, first), fit_mode1(colors, second)}};
        if (lines.error() < best.error()) {
            best = lines;
        }
    }
    return best;
}

// For every value of 8 bits, two endpoints of 7 bits between which the weight 21 / 64 gives it.
using ExactEnds = std::array<std::array<int, 2>, 256>;

ExactEnds make_exact_ends() {
    ExactEnds ends{};
    for (int first = 127; first >= 0; --first) {
        for (int second = 127; second >= 0; --second) {
            const int value = interpolated(expanded7(first), expanded7(second), kWeights2[1]);
            ends[static_cast<std::size_t>(value)] = {first, second};
        }
    }
    return ends;
}

// Stores a block of a single color exactly, in mode 5 with the index 1 for all colors.
Block write_solid(const std::array<std::uint8_t, 4>& color) {
    static const ExactEnds exact = make_exact_ends();
    BitWriter bits;
    bits.write(1 << 5, 6);
    bits.write(0, 2);
    for (std::size_t c = 0; c < 3; ++c) {
        bits.write(exact[color[c]][0], 7);
        bits.write(exact[color[c]][1], 7);
    }
    bits.write(color[3], 8);
    bits.write(color[3], 8);
    for (int k = 0; k < kBlockTexels; ++k) {
        bits.write(1, k == 0 ? 1 : 2);
    }
    return bits.bytes();  // the indices of alpha are 0
}

}  // namespace

Block encode_bc7(const TexelBlock& texels) {
    if (std::ranges::all_of(texels, [&](const auto& texel) { return texel == texels.front(); })) {
        return write_solid(texels.front());
    }
    const Colors colors(texels);
    const Fit one = fit_mode6(colors, kAllTexels);
    if (colors.opaque && one.error > kGoodEnough) {
        const TwoLines two = fit_two_lines(colors);
        if (two.error() < one.error) {
            return write_mode1(two);
        }
    }
    return write_mode6(one);
}

}  // namespace foam::texgen
