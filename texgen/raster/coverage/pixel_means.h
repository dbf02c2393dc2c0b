// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/coverage/coverage.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace foam::texgen {

/// Returns the samples of a pixel in one word. The byte that is first in the image is the lowest
/// byte of the word.
template <class Sample, std::size_t Channels>
std::uint64_t packed(const std::array<Sample, Channels>& samples) {
    std::uint64_t pixel = 0;
    for (std::size_t c = 0; c < Channels; ++c) {
        Sample sample = samples[c];
        if constexpr (std::endian::native == std::endian::big && sizeof(Sample) == 2) {
            sample = __builtin_bswap16(sample);
        }
        pixel |= std::uint64_t{sample} << (8 * sizeof(Sample) * c);
    }
    return pixel;
}

/// Computes the mean of each sum (Sums::mean) and stores the means in the array `to`, in the order
/// of the sums.
template <class Sums>
void find_means(std::span<const typename Sums::Number> sums, std::uint16_t* to) {
    at_simd_level([sums, to] {
        std::uint16_t* __restrict means = to;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            means[k] = static_cast<std::uint16_t>(Sums::mean(sums[k]));
        }
    });
}

/// Converts sums to pixels whose samples are encode(mean). A call stores one packed pixel per sum.
/// Precondition: there is at least one sum. Buffers are reused between rows.
template <std::size_t Channels, class Sums, class Encode>
class EncodedMeans {
  public:
    explicit EncodedMeans(const Encode& encode) : encode_(encode) {}

    void operator()(std::span<const typename Sums::Sum> sums, std::uint64_t* pixels) {
        constexpr std::size_t kChannels = std::tuple_size_v<typename Sums::Sum>;
        grow(means_, kChannels * sums.size());
        find_means<Sums>({sums.front().data(), kChannels * sums.size()}, means_.data());
        const Encode encode = encode_;  // a copy, which the stores below cannot change
        const std::uint16_t* means = means_.data();
        for (std::size_t k = 0; k < sums.size(); ++k, means += kChannels) {
            std::array<decltype(encode(std::uint16_t{})), Channels> samples{};
            for (std::size_t c = 0; c < Channels; ++c) {
                samples[c] = encode(means[c]);
            }
            pixels[k] = packed(samples);
        }
    }

  private:
    Encode encode_;
    std::vector<std::uint16_t> means_;
};

/// Converts sums of premultiplied colors to pixels of straight colors. The last channel is the
/// opacity; the other channels are divided by it. A call stores one packed pixel per sum.
template <std::size_t Channels>
struct StraightMeans {
    using Sums = ExactSums<Channels>;
    using Samples = std::array<std::uint16_t, Channels>;

    void operator()(std::span<const typename Sums::Sum> sums, std::uint64_t* pixels) const {
        for (std::size_t k = 0; k < sums.size(); ++k) {
            pixels[k] = packed(samples_of(sums[k]));
        }
    }

    /// Returns the samples of a pixel. All of them are 0 if the opacity is 0 or negative.
    static Samples samples_of(const typename Sums::Sum& sum) {
        Samples samples{};
        const auto opacity = static_cast<std::int64_t>(sum[Channels - 1]);
        if (opacity <= 0) {
            return samples;
        }
        for (std::size_t c = 0; c + 1 < Channels; ++c) {
            const auto whole = static_cast<std::int64_t>(sum[c]);
            const std::int64_t color = (whole * kLargestMean + opacity / 2) / opacity;
            samples[c] =
                static_cast<std::uint16_t>(std::clamp<std::int64_t>(color, 0, kLargestMean));
        }
        samples[Channels - 1] = static_cast<std::uint16_t>(Sums::mean(sum[Channels - 1]));
        return samples;
    }
};

}  // namespace foam::texgen
