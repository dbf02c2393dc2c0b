#pragma once

#include "texgen/raster/coverage_sums.h"
#include "texgen/raster/make_room.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Each mean, encoded: encode(mean) is a sample. Keeps its memory from one row to the next.
template <std::size_t Channels, class Sums, class Encode>
class EncodedMeans {
  public:
    explicit EncodedMeans(const Encode& encode) : encode_(encode) {}

    template <class Put>
    void operator()(std::span<const typename Sums::Sum> sums, const Put& put) {
        make_room(means_, sums.size());
        const std::span means = std::span(means_).first(sums.size());
        std::ranges::transform(sums, means.begin(), Sums::means);
        hold_in_range(means);
        for (std::size_t k = 0; k < means.size(); ++k) {
            std::array<decltype(encode_(std::uint16_t{})), Channels> samples{};
            for (std::size_t c = 0; c < Channels; ++c) {
                samples[c] = encode_(static_cast<std::uint16_t>(means[k][c]));
            }
            put(k, samples);
        }
    }

  private:
    Encode encode_;
    std::vector<MeansOf<typename Sums::Sum>> means_;
};

/// The last mean, and the others over it.
template <std::size_t Channels>
struct StraightMeans {
    using Sums = ExactSums<Channels>;
    using Samples = std::array<std::uint16_t, Channels>;

    template <class Put>
    void operator()(std::span<const typename Sums::Sum> sums, const Put& put) const {
        for (std::size_t k = 0; k < sums.size(); ++k) {
            put(k, samples_of(sums[k]));
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
        samples[Channels - 1] =
            static_cast<std::uint16_t>(std::clamp(Sums::means(sum)[Channels - 1], 0, kLargestMean));
        return samples;
    }
};

}  // namespace foam::texgen
