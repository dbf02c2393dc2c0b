// SPDX-License-Identifier: Apache-2.0

#include "texgen/blocks/bc7_partition.h"

#include "texgen/blocks/bc7_modes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

// The sum of the squared distances from the principal axis is the trace of the scatter matrix minus
// its largest eigenvalue. The scatter matrix of a subset follows from sums over its texels. Those
// of the first subset are the sums over all texels minus the sums over the second subset.

namespace foam::texgen::bc7 {

namespace {

// A number for each partition. Loops over partitions are vectorized by the compiler.
using PerPartition = std::array<float, kPartitions>;

// The sums of an opaque subset from which the scatter matrix of its colors follows.
// The first is the number of texels, then come the components and their products.
constexpr std::size_t kSums = 10;
constexpr std::size_t kCount = 0;
constexpr std::size_t kR = 1;
constexpr std::size_t kG = 2;
constexpr std::size_t kB = 3;
constexpr std::size_t kRR = 4;
constexpr std::size_t kRG = 5;
constexpr std::size_t kRB = 6;
constexpr std::size_t kGG = 7;
constexpr std::size_t kGB = 8;
constexpr std::size_t kBB = 9;
using Sums = std::array<float, kSums>;

Sums terms_of(const Color& color) {
    const auto [r, g, b, a] = color;
    return {1.0F, r, g, b, r * r, r * g, r * b, g * g, g * b, b * b};
}

// For each texel and each partition: 1 if the texel is in the second subset, otherwise 0.
using Memberships = std::array<PerPartition, kBlockTexels>;

constexpr Memberships make_memberships() {
    Memberships memberships{};
    for (std::size_t texel = 0; texel < memberships.size(); ++texel) {
        for (std::size_t k = 0; k < kPartitionMasks.size(); ++k) {
            memberships[texel][k] = (kPartitionMasks[k] >> texel & 1U) != 0 ? 1.0F : 0.0F;
        }
    }
    return memberships;
}

constexpr Memberships kMemberships = make_memberships();

// Returns the sum of the squared distances of the colors of a subset from their principal axis. Two
// steps of power iteration, which begins with the column of the largest variance, are enough to
// compare partitions. The vector is scaled by the trace, so that its numbers do not overflow.
inline float residual_of(const Sums& sums) {
    const float scale = 1.0F / sums[kCount];
    const float rr = sums[kRR] - sums[kR] * sums[kR] * scale;
    const float rg = sums[kRG] - sums[kR] * sums[kG] * scale;
    const float rb = sums[kRB] - sums[kR] * sums[kB] * scale;
    const float gg = sums[kGG] - sums[kG] * sums[kG] * scale;
    const float gb = sums[kGB] - sums[kG] * sums[kB] * scale;
    const float bb = sums[kBB] - sums[kB] * sums[kB] * scale;
    const float trace = rr + gg + bb;
    constexpr float kTiny = 1e-3F;  // avoids divisions by 0 if all colors are equal
    const float unit = 1.0F / (trace + kTiny);
    const bool red = rr >= gg && rr >= bb;
    const bool green = gg >= bb;
    float x = (red ? rr : green ? rg : rb) * unit;
    float y = (red ? rg : green ? gg : gb) * unit;
    float z = (red ? rb : green ? gb : bb) * unit;
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
    constexpr float kSmallest = 1e-30F;
    const float residual = trace - product / (square + kSmallest);
    return residual > 0.0F ? residual : 0.0F;
}

// Returns the sum of the residuals of both subsets of every partition.
PerPartition residuals_of(const Colors& colors) {
    Sums all{};
    std::array<PerPartition, kSums> second{};
    for (std::size_t texel = 0; texel < colors.texels.size(); ++texel) {
        const Sums terms = terms_of(colors.texels[texel]);
        const PerPartition& members = kMemberships[texel];
        for (std::size_t c = 0; c < kSums; ++c) {
            all[c] += terms[c];
            for (std::size_t k = 0; k < members.size(); ++k) {
                second[c][k] += terms[c] * members[k];
            }
        }
    }
    PerPartition residuals{};
    for (std::size_t k = 0; k < residuals.size(); ++k) {
        Sums ones{};
        Sums others{};
        for (std::size_t c = 0; c < kSums; ++c) {
            ones[c] = second[c][k];
            others[c] = all[c] - second[c][k];
        }
        residuals[k] = residual_of(ones) + residual_of(others);
    }
    return residuals;
}

}  // namespace

std::array<int, kTriedPartitions> best_partitions(const Colors& colors) {
    PerPartition residuals = residuals_of(colors);
    std::array<int, kTriedPartitions> best{};
    for (int& partition : best) {
        auto* const smallest = std::ranges::min_element(residuals);
        partition = static_cast<int>(smallest - residuals.begin());
        *smallest = std::numeric_limits<float>::infinity();
    }
    return best;
}

}  // namespace foam::texgen::bc7
