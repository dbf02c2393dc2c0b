// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/blocks/bc7_fit.h"
#include "texgen/blocks/bc7_pack.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// Blocks of BC7 are compressed in groups, one block per lane of a SIMD register.

namespace foam::texgen::bc7 {

/// The blocks of one call of encode_bc7, and the best result for each of them.
struct Work {
    std::span<const TexelBlock> texels;
    std::span<Bc7Block> blocks;
    std::vector<float> errors;  // sums of squared errors; infinity before the first result
};

using Numbers = std::vector<std::uint32_t>;  // indices of blocks

/// A group of blocks, one per lane. If there are fewer blocks than lanes, the last one is repeated.
template <class Simd>
class Group {
  public:
    using Floats = typename Simd::Floats;
    using Ints = typename Simd::Ints;

    Group(Work& work, std::span<const std::uint32_t> numbers) : work_(work), numbers_(numbers) {}

    /// Returns the given channels of the blocks.
    template <std::size_t kChannels>
    FOAM_INLINE ColorLanes<Simd, kChannels> colors(
        const KernelArray<std::size_t, kChannels>& channels) const {
        alignas(64)
            KernelArray<KernelArray<KernelArray<float, Simd::kCount>, kChannels>, kBlockTexels>
                values;
        for (std::size_t lane = 0; lane < Simd::kCount; ++lane) {
            const TexelBlock& block = work_.texels[numbers_[std::min(lane, numbers_.size() - 1)]];
            for (std::size_t k = 0; k < kBlockTexels; ++k) {
                for (std::size_t c = 0; c < kChannels; ++c) {
                    values[k][c][lane] = static_cast<float>(block[k][channels[c]]);
                }
            }
        }
        ColorLanes<Simd, kChannels> colors;
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            for (std::size_t c = 0; c < kChannels; ++c) {
                colors[k][c] = Floats::load(values[k][c].data());
            }
        }
        return colors;
    }

    /// Packs and stores a new result for each block whose error in `errors` is smaller than that of
    /// its best result so far. `fields(lane)` returns the fields of the new result.
    template <class Fields>
    FOAM_INLINE void offer(const Floats& errors, const Fields& fields) {
        KernelArray<float, Simd::kCount> found;
        errors.store(found.data());
        for (std::size_t lane = 0; lane < numbers_.size(); ++lane) {
            const std::uint32_t number = numbers_[lane];
            if (found[lane] < work_.errors[number]) {
                work_.errors[number] = found[lane];
                work_.blocks[number] = pack_bc7(fields(lane));
            }
        }
    }

  private:
    Work& work_;
    std::span<const std::uint32_t> numbers_;
};

/// Divides the blocks with the given numbers into groups, and calls body(group) for each group at
/// the SIMD level in use.
template <class Body>
void encode_groups(Work& work, const Numbers& numbers, const Body& body) {
    at_simd_level([&](auto level) FOAM_INLINE_LAMBDA {
        using Simd = LanesAt<decltype(level)::value>;
        for (std::size_t first = 0; first < numbers.size(); first += Simd::kCount) {
            const std::size_t count = std::min(Simd::kCount, numbers.size() - first);
            body(Group<Simd>(work, std::span(numbers).subspan(first, count)));
        }
    });
}

/// The partition, the endpoints and the indices of a fit, copied from registers into arrays that
/// can be read lane by lane.
template <class Simd, class Format>
struct StoredFit {
    FOAM_INLINE explicit StoredFit(const Fit<Simd, Format>& fit) {
        for (std::size_t s = 0; s < Format::kSubsets; ++s) {
            for (std::size_t end = 0; end < 2; ++end) {
                for (std::size_t c = 0; c < Format::kChannels; ++c) {
                    Simd::whole(fit.ends[s][end][c]).store(ends[s][end][c].data());
                }
            }
        }
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            fit.indices[k].store(indices[k].data());
        }
        fit.partition.store(partitions.data());
    }

    BlockFields fields(int mode, std::size_t lane) const {
        BlockFields fields{.mode = mode, .partition = partitions[lane]};
        for (std::size_t s = 0; s < Format::kSubsets; ++s) {
            for (std::size_t end = 0; end < 2; ++end) {
                fields.ends[s][end][3] = 255;
                for (std::size_t c = 0; c < Format::kChannels; ++c) {
                    fields.ends[s][end][c] = ends[s][end][c][lane];
                }
            }
        }
        for (std::size_t k = 0; k < kBlockTexels; ++k) {
            fields.indices[k] = indices[k][lane];
        }
        return fields;
    }

    using PerLane = KernelArray<std::int32_t, Simd::kCount>;
    PerLane partitions;
    KernelArray<KernelArray<KernelArray<PerLane, Format::kChannels>, 2>, Format::kSubsets> ends;
    KernelArray<PerLane, kBlockTexels> indices;
};

}  // namespace foam::texgen::bc7
