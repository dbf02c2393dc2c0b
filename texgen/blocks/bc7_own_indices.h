// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/bc7_fit.h"
#include "texgen/blocks/bc7_group.h"

#include <cstddef>

// The modes 4 and 5 of BC7, in which one channel has indices of its own. A block stores this
// channel in the place of alpha: BlockFields::rotation says which channel is exchanged with alpha.

namespace foam::texgen::bc7 {

/// A mode in which one channel has indices of its own.
template <int kModeNumber, class ColorFormat, class AlphaFormat, bool kExchangesIndices>
struct OwnIndices {
    static constexpr int kMode = kModeNumber;
    using Colors = ColorFormat;
    using Alpha = AlphaFormat;
    static constexpr bool kExchanges = kExchangesIndices;
};

using Mode4 = OwnIndices<4,
                         Format<1, 3, 5, LowestBits::None, 2>,
                         Format<1, 1, 6, LowestBits::None, 3>,
                         false>;
using Mode4Exchanged =
    OwnIndices<4, Format<1, 3, 5, LowestBits::None, 3>, Format<1, 1, 6, LowestBits::None, 2>, true>;
using Mode5 = OwnIndices<5,
                         Format<1, 3, 7, LowestBits::None, 2>,
                         Format<1, 1, 8, LowestBits::None, 2>,
                         false>;

/// Returns the channel that should have indices of its own in a mode (OwnIndices), so that the
/// error is smallest. The error is estimated from the scatter matrix of the colors, as explained in
/// bc7_partition.h. This channel is rounded alone; the other channels are rounded along one line.
template <class Own, class Simd, std::size_t kChannels>
FOAM_INLINE typename Simd::Ints own_channel(const ColorLanes<Simd, kChannels>& colors) {
    using Floats = typename Simd::Floats;
    const auto differences = relative<Simd, kChannels>(colors);
    ColorSums<Simd, kChannels> sums;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        sums.add(sums_of<Simd, kChannels>(differences[k]));
    }
    ColorOf<Simd, kChannels> mean;
    for (std::size_t c = 0; c < kChannels; ++c) {
        mean[c] = sums.colors[c] * Floats(1.0F / kBlockTexels);
    }
    const auto scatter = scatter_of<Simd, kChannels>(sums, mean);
    Floats smallest = 1e30F;
    typename Simd::Ints best;
    for (std::size_t own = 0; own < kChannels; ++own) {
        Floats trace;
        Floats squares;
        for (std::size_t c = 0; c < kChannels; ++c) {
            trace += c == own ? Floats() : scatter[c][c];
            for (std::size_t d = 0; d < kChannels; ++d) {
                squares += c == own || d == own ? Floats() : scatter[c][d] * scatter[c][d];
            }
        }
        const Floats along = Simd::square_root(squares);
        const Floats error = trace - along + along * Floats(kRoundingShare<typename Own::Colors>) +
                             scatter[own][own] * Floats(kRoundingShare<typename Own::Alpha>);
        best = Simd::select(
            Simd::less(error, smallest), typename Simd::Ints(static_cast<int>(own)), best);
        smallest = Simd::smaller(smallest, error);
    }
    return best;
}

/// Tries a mode in which one channel has indices of its own (OwnIndices).
template <class Own, class Simd, std::size_t kChannels>
FOAM_INLINE void try_own_indices(Group<Simd>& group, const ColorLanes<Simd, kChannels>& colors) {
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;
    const Ints own = own_channel<Own, Simd, kChannels>(colors);
    ColorLanes<Simd, 3> others;
    ColorLanes<Simd, 1> own_values;
    for (std::size_t k = 0; k < kBlockTexels; ++k) {
        const Floats alpha = kChannels > 3 ? colors[k][kChannels - 1] : Floats(255.0F);
        own_values[k][0] = alpha;
        for (std::size_t c = 0; c < 3; ++c) {
            const Ints is_own = Simd::equal(own, Ints(static_cast<int>(c)));
            own_values[k][0] = Simd::select(is_own, colors[k][c], own_values[k][0]);
            others[k][c] = Simd::select(is_own, alpha, colors[k][c]);
        }
    }
    const auto color = fit_line<typename Own::Colors, Simd>(others);
    const auto alpha = fit_line<typename Own::Alpha, Simd>(own_values);
    const StoredFit<Simd, typename Own::Colors> stored_color(color);
    const StoredFit<Simd, typename Own::Alpha> stored_alpha(alpha);
    KernelArray<std::int32_t, Simd::kCount> channels;
    own.store(channels.data());
    group.offer(color.error + alpha.error, [&](std::size_t lane) {
        BlockFields fields = stored_color.fields(Own::kMode, lane);
        const BlockFields stored = stored_alpha.fields(Own::kMode, lane);
        fields.exchanges_indices = Own::kExchanges;
        fields.rotation = channels[lane] < 3 ? channels[lane] + 1 : 0;
        fields.ends[0][0][3] = stored.ends[0][0][0];
        fields.ends[0][1][3] = stored.ends[0][1][0];
        fields.alpha_indices = stored.indices;
        return fields;
    });
}

}  // namespace foam::texgen::bc7
