// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/files/file_io.h"
#include "texgen/image/image.h"
#include "texgen/image/png.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// The rows of a picture of 8-bit or 16-bit samples in the order of PNG. The top row is first, and
/// the high byte of a 16-bit sample is first. A PngRows object refers to the samples, which must
/// outlive it.
class PngRows {
  public:
    explicit PngRows(ImageView<const std::uint8_t> view) : PngRows(view, 1) {}
    explicit PngRows(ImageView<const std::uint16_t> view) : PngRows(view, 2) {}

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }
    int bit_depth() const { return 8 * static_cast<int>(sample_bytes_); }
    std::size_t pixel_bytes() const { return sample_bytes_ * static_cast<std::size_t>(channels_); }
    std::size_t row_bytes() const { return pixel_bytes() * static_cast<std::size_t>(width_); }

    /// Copies one row; `row` counts from the top. Precondition: `to` has row_bytes() bytes.
    void copy_row(int row, std::span<std::byte> to) const;

  private:
    template <class View>
    PngRows(View view, std::size_t sample_bytes)
        : bottom_(reinterpret_cast<const std::byte*>(view.data())),
          width_(view.width()),
          height_(view.height()),
          channels_(view.channels()),
          sample_bytes_(sample_bytes) {}

    const std::byte* bottom_;  // the samples, beginning with the bottom row
    int width_;
    int height_;
    int channels_;
    std::size_t sample_bytes_;
};

/// Applies the filters of section 9 of the PNG specification to rows. Its buffers are reused
/// between calls.
class RowFilter {
  public:
    /// Returns the filtered rows first, first + 1, ..., last - 1, counted from the top. The byte of
    /// the filter type precedes each row. The result is valid until the next call.
    std::span<const std::byte> filter(const PngRows& rows, PngFilter filter, int first, int last);

  private:
    Bytes above_;     // a pixel of zeros and the row above the current row
    Bytes current_;   // a pixel of zeros and the current row
    Bytes filtered_;  // the result of `filter`
};

}  // namespace foam::texgen
