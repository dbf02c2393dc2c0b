// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_partition.h"

#include "texgen/blocks/bc7_modes.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <utility>

// The sum of the squared distances from the principal axis is the trace of the scatter matrix minus
// its largest eigenvalue. The scatter matrix of a subset follows from sums over its texels. Those
// of the first subset are the sums over all texels minus the sums over the second subset.

namespace foam::texgen::bc7 {

namespace {

// The sums of an opaque subset from which the scatter matrix of its colors follows: the components,
// then the products rr, rg, rb, gg, gb and bb, then the number of texels.
using Sums = std::array<float, 12>;

std::array<Sums, kBlockTexels> terms_of(const Colors& colors) {
    std::array<Sums, kBlockTexels> terms{};
    for (std::size_t k = 0; k < terms.size(); ++k) {
        const auto& [r, g, b, a] = colors.texels[k];
        terms[k] = {r, g, b, r * r, r * g, r * b, g * g, g * b, b * b, 1.0F};
    }
    return terms;
}

// Returns the sum of the squared distances of the colors of a subset from their principal axis. Two
// steps of power iteration are enough to compare partitions.
float residual_of(const Sums& sums) {
    const float scale = 1.0F / sums[9];
    const float rr = sums[3] - sums[0] * sums[0] * scale;
    const float rg = sums[4] - sums[0] * sums[1] * scale;
    const float rb = sums[5] - sums[0] * sums[2] * scale;
    const float gg = sums[6] - sums[1] * sums[1] * scale;
    const float gb = sums[7] - sums[1] * sums[2] * scale;
    const float bb = sums[8] - sums[2] * sums[2] * scale;
    const float trace = rr + gg + bb;
    if (trace < 1e-3F) {
        return 0.0F;
    }
    const float unit = 1.0F / trace;
    float x = rr >= gg && rr >= bb ? rr : gg >= bb ? rg : rb;
    float y = rr >= gg && rr >= bb ? rg : gg >= bb ? gg : gb;
    float z = rr >= gg && rr >= bb ? rb : gg >= bb ? gb : bb;
    for (int k = 0; k < 2; ++k) {
        const float next_x = (rr * x + rg * y + rb * z) * unit;
        const float next_y = (rg * x + gg * y + gb * z) * unit;
        const float next_z = (rb * x + gb * y + bb * z) * unit;
        x = next_x;
        y = next_y;
        z = next_z;
    }
    const float square = x * x + y * y + z * z;
    const float product = x * (rr * x + rg * y + rb * z) + y * (rg * x + gg * y + gb * z) +
                          z * (rb * x + gb * y + bb * z);
    return square > 0.0F ? std::max(trace - product / square, 0.0F) : trace;
}

}  // namespace

std::array<int, kTriedPartitions> best_partitions(const Colors& colors) {
    const std::array<Sums, kBlockTexels> terms = terms_of(colors);
    Sums all{};
    for (const Sums& term : terms) {
        for (std::size_t c = 0; c < all.size(); ++c) {
            all[c] += term[c];
        }
    }
    std::array<std::pair<float, int>, kPartitions> order;
    for (int partition = 0; partition < kPartitions; ++partition) {
        Sums second{};
        for (unsigned rest = kPartitionMasks[static_cast<std::size_t>(partition)]; rest != 0;
             rest &= rest - 1) {
            const Sums& term = terms[static_cast<std::size_t>(std::countr_zero(rest))];
            for (std::size_t c = 0; c < all.size(); ++c) {
                second[c] += term[c];
            }
        }
        Sums first{};
        for (std::size_t c = 0; c < all.size(); ++c) {
            first[c] = all[c] - second[c];
        }
        order[static_cast<std::size_t>(partition)] = {residual_of(first) + residual_of(second),
                                                      partition};
    }
    std::partial_sort(order.begin(), order.begin() + kTriedPartitions, order.end());
    std::array<int, kTriedPartitions> best{};
    for (std::size_t k = 0; k < best.size(); ++k) {
        best[k] = order[k].second;
    }
    return best;
}

}  // namespace foam::texgen::bc7
