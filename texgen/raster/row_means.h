#pragma once

#include "texgen/raster/coverage_sums.h"
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

/// Samples as they lie in memory, the first in the lowest bits.
template <class Word, class Sample, std::size_t Channels>
Word packed(const std::array<Sample, Channels>& samples) {
    Word pixel = 0;
    for (std::size_t c = 0; c < Channels; ++c) {
        Sample sample = samples[c];
        if constexpr (std::endian::native == std::endian::big && sizeof(Sample) == 2) {
            sample = __builtin_bswap16(sample);
        }
        pixel |= static_cast<Word>(sample) << (8 * sizeof(Sample) * c);
    }
    return pixel;
}

/// The means of some sums, which are those of ExactSums, or of SmallSums.
void find_means(std::span<const double> sums, std::uint16_t* means);
void find_means(std::span<const std::uint32_t> sums, std::uint16_t* means);

/// Each mean, encoded: encode(mean) is a sample. Keeps its memory from one row to the next.
template <std::size_t Channels, class Sums, class Encode>
class EncodedMeans {
  public:
    explicit EncodedMeans(const Encode& encode) : encode_(encode) {}

    template <class Word>
    void operator()(std::span<const typename Sums::Sum> sums, Word* pixels) {
        constexpr std::size_t kChannels = std::tuple_size_v<typename Sums::Sum>;
        grow(means_, kChannels * sums.size());
        find_means({sums.front().data(), kChannels * sums.size()}, means_.data());
        const Encode encode = encode_;  // a copy, which no pixel changes
        const std::uint16_t* means = means_.data();
        for (std::size_t k = 0; k < sums.size(); ++k, means += kChannels) {
            std::array<decltype(encode(std::uint16_t{})), Channels> samples{};
            for (std::size_t c = 0; c < Channels; ++c) {
                samples[c] = encode(means[c]);
            }
            pixels[k] = packed<Word>(samples);
        }
    }

  private:
    Encode encode_;
    std::vector<std::uint16_t> means_;
};

/// The last mean, and the others over it.
template <std::size_t Channels>
struct StraightMeans {
    using Sums = ExactSums<Channels>;
    using Samples = std::array<std::uint16_t, Channels>;

    template <class Word>
    void operator()(std::span<const typename Sums::Sum> sums, Word* pixels) const {
        for (std::size_t k = 0; k < sums.size(); ++k) {
            pixels[k] = packed<Word>(samples_of(sums[k]));
        }
    }

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
