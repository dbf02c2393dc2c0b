// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/simd_level.h"
#include "texgen/image/image.h"

#include <cstddef>
#include <cstring>

namespace foam::texgen {

/// The samples of one channel in a row of an image. Refers to the image, which must outlive it.
template <class Sample>
struct ChannelRow {
    ChannelRow(const ImageView<const Sample>& image, int y, int channel)
        : first(&image.row(y)[static_cast<std::size_t>(channel)]),
          step(static_cast<std::size_t>(image.channels())),
          count(static_cast<std::size_t>(image.width())) {}

    /// Computes convert(sample) for each sample in a vectorized loop, and writes the results to
    /// `to`, without gaps. `convert` has to capture by value, and all functions that it calls have
    /// to be inline.
    template <class Convert>
    void write(const Convert& convert, std::byte* to) const {
        using Stored = decltype(convert(Sample()));
        at_simd_level([row = *this, convert, to] {
            for (std::size_t x = 0; x < row.count; ++x) {
                const Stored stored = convert(row.first[x * row.step]);
                std::memcpy(to + x * sizeof(Stored), &stored, sizeof(Stored));
            }
        });
    }

    const Sample* first;
    std::size_t step;  // number of samples from one pixel to the next
    std::size_t count;
};

}  // namespace foam::texgen
