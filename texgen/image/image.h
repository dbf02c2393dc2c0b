// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/cache_line.h"

#include <boost/align/aligned_allocator.hpp>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace foam::texgen {

/// A view of the samples of an Image. The view does not own the samples. `ImageView<const Sample>`
/// is read-only. Rows run upward, like the y axis of the foam: row 0 is the bottom row of the
/// picture. A row has `width` pixels of `channels` interleaved samples. A view is small and should
/// be passed by value.
template <class Sample>
class ImageView {
  public:
    ImageView() = default;
    ImageView(Sample* samples, int width, int height, int channels)
        : samples_(samples), width_(width), height_(height), channels_(channels) {}

    /// Converts a writable view to a read-only view.
    template <class Other>
    requires std::is_same_v<Sample, const Other> ImageView(ImageView<Other> other)
        : ImageView(other.data(), other.width(), other.height(), other.channels()) {}

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }
    /// Returns a pointer to the first sample of row 0.
    Sample* data() const { return samples_; }

    /// Returns the number of samples in a row.
    std::size_t row_samples() const {
        return static_cast<std::size_t>(width_) * static_cast<std::size_t>(channels_);
    }

    /// Returns the samples of row y.
    std::span<Sample> row(int y) const {
        assert(y >= 0 && y < height_);
        return {samples_ + static_cast<std::size_t>(y) * row_samples(), row_samples()};
    }
    /// Returns the samples of one pixel, one per channel. x counts from the left.
    std::span<Sample> pixel(int x, int y) const {
        assert(x >= 0 && x < width_);
        const auto channels = static_cast<std::size_t>(channels_);
        return row(y).subspan(static_cast<std::size_t>(x) * channels, channels);
    }

  private:
    Sample* samples_ = nullptr;
    int width_ = 0;
    int height_ = 0;
    int channels_ = 0;
};

/// Owns the samples of a picture in the layout of ImageView. The first sample is aligned to a cache
/// line, which makes vector stores fastest.
template <class Sample>
class Image {
  public:
    Image() = default;

    /// Creates an image whose samples are all 0. Throws std::invalid_argument unless width, height
    /// and channels are positive.
    Image(int width, int height, int channels)
        : width_(width),
          height_(height),
          channels_(channels),
          samples_(sample_count(width, height, channels)) {}

    int width() const { return width_; }
    int height() const { return height_; }
    int channels() const { return channels_; }

    std::span<Sample> samples() { return samples_; }
    std::span<const Sample> samples() const { return samples_; }
    std::span<Sample> row(int y) { return view().row(y); }
    std::span<const Sample> row(int y) const { return view().row(y); }
    std::span<Sample> pixel(int x, int y) { return view().pixel(x, y); }
    std::span<const Sample> pixel(int x, int y) const { return view().pixel(x, y); }

    ImageView<Sample> view() { return {samples_.data(), width_, height_, channels_}; }
    ImageView<const Sample> view() const { return {samples_.data(), width_, height_, channels_}; }

    friend bool operator==(const Image&, const Image&) = default;

  private:
    static std::size_t sample_count(int width, int height, int channels) {
        if (std::min({width, height, channels}) < 1) {
            throw std::invalid_argument("an image needs at least one pixel and one channel");
        }
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
               static_cast<std::size_t>(channels);
    }

    int width_ = 0;
    int height_ = 0;
    int channels_ = 0;
    std::vector<Sample, boost::alignment::aligned_allocator<Sample, kLineBytes>> samples_;
};

}  // namespace foam::texgen
