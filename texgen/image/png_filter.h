// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/file_io.h"
#include "texgen/image/image.h"
#include "texgen/image/png.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// The rows of a picture of 8-bit or 16-bit samples in the order of PNG: the top row first, and the
/// high byte of 16-bit samples first. Borrows the samples.
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

    const std::byte* bottom_;
    int width_;
    int height_;
    int channels_;
    std::size_t sample_bytes_;
};

/// Filters rows by the filters of section 9 of the PNG specification. Its buffers are reused
/// between calls.
class RowFilter {
  public:
    /// Returns the filtered rows first, first + 1, ..., last - 1, counted from the top, each
    /// preceded by the byte of its filter type. Valid until the next call.
    std::span<const std::byte> filter(const PngRows& rows, PngFilter filter, int first, int last);

  private:
    Bytes above_;  // the preceding row, after a pixel of zeros
    Bytes current_;
    Bytes filtered_;
};

}  // namespace foam::texgen
