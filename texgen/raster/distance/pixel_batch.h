// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"
#include "core/parallel/kernel_array.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace foam::texgen {

/// A quadratic function of a position d relative to the middle of a batch of pixels (PixelBatch).
/// Its value is twice_value / 2 + (x, y) · d - curvature / 2 · d².
struct FloatQuadratic {
    float twice_value = 0.0F;
    float x = 0.0F;
    float y = 0.0F;
    float curvature = 0.0F;
};

/// The signed distance of a point from a line. At a position d relative to the middle of a batch,
/// it is value + (x, y) · d.
struct FloatLine {
    float value = 0.0F;
    float x = 0.0F;
    float y = 0.0F;
};

/// The functions of an arc that determine distances. `across` is 0 on the circle of the arc and has
/// slope 1 there. `past_tail` and `before_head` are the signed distances from the normals of the
/// arc at its tail and at its head, positive on the side of the arc.
struct ArcFunctions {
    FloatQuadratic across;
    FloatLine past_tail;
    FloatLine before_head;
};

/// The functions of a film that determine smooth distances. `across` is ArcFunctions::across of the
/// film's arc. `along` is 0 on the circle that is normal to the arc at both ends, has slope 1
/// there, and is positive on the film.
struct FilmFunctions {
    FloatQuadratic across;
    FloatQuadratic along;
    float chord = 0.0F;  // length of the chord, pixels
};

/// Up to 1600 pixels that are close together, with their distances, gradients and smooth distances.
/// Columns, rows and the middle of the batch are in the coordinates of the caller, in pixels. For a
/// region, they are relative to the lower left corner of its box (RegionPixels). Functions of arcs
/// are evaluated in doubles at the middle of the batch. All further arithmetic is in floats
/// relative to the middle, which avoids cancellation, however large the arcs are.
class PixelBatch {
  public:
    static constexpr std::size_t kCapacity = 1600;
    static constexpr std::size_t kLanes = 16;  // number of pixels measured at once
    static constexpr double kMargin = 0.01;    // upper bound of the error of a distance, pixels
    using Values = KernelArray<float, kCapacity + kLanes>;

    /// Adjacent pixels of a row.
    struct Span {
        int column = 0;  // column of the first pixel
        int row = 0;
        std::uint32_t first = 0;  // index of the first pixel in the values of the batch
        std::uint32_t count = 0;
    };

    /// Starts an empty batch. Precondition: both coordinates of the middle are multiples of 1/2.
    void clear(const Vec2& middle);
    /// Adds `count` pixels of a row, starting with the given column. Precondition: the capacity is
    /// not exceeded.
    void add_span(int column, int row, int count);

    const Vec2& middle() const { return middle_; }
    std::span<const Span> spans() const { return std::span(spans_).first(span_count_); }
    bool is_empty() const { return count_ == 0; }

    /// Computes the distance of each pixel to the nearest point or arc, and its gradient if
    /// `gradient` is true. Only arcs that the pixel faces count. A pixel faces an arc if it is
    /// between the normals at both ends of the arc, or at most 0.001 pixels beyond one of them.
    /// Arcs and points are relative to the middle. Returns false if any distance is infinite,
    /// because a pixel faces no arc and there are no points.
    bool measure(std::span<const ArcFunctions> arcs, std::span<const Vec2> points, bool gradient);

    /// Computes smooth distances, and their gradients if `gradient` is true. If there are no films,
    /// or if the smooth distance would be 1e6 pixels or more, they equal the distance and its
    /// gradient. If measure() has not computed these before, they are meaningless for such pixels.
    /// Returns false if there is such a pixel.
    bool measure_smooth(std::span<const FilmFunctions> films, bool gradient);

    /// Return the results of measure() and measure_smooth(), one value per pixel. Span::first is
    /// the index of the first pixel of a span. Elements after the last pixel are meaningless.
    const Values& distance() const { return distance_; }
    const Values& gradient_x() const { return gradient_x_; }
    const Values& gradient_y() const { return gradient_y_; }
    const Values& smooth() const { return smooth_; }
    const Values& smooth_x() const { return smooth_x_; }
    const Values& smooth_y() const { return smooth_y_; }

  private:
    std::size_t padded_count() const { return (count_ + kLanes - 1) / kLanes * kLanes; }
    void pad();

    Vec2 middle_{0.0, 0.0};
    // The x and the y of the vector from the center of pixel (0, 0) to the middle. The floats are
    // exact, because the coordinates of the middle are multiples of 1/2.
    float to_middle_x_ = 0.0F;
    float to_middle_y_ = 0.0F;
    std::size_t count_ = 0;
    std::size_t span_count_ = 0;
    KernelArray<Span, kCapacity> spans_;
    alignas(64) Values x_{};  // positions relative to the middle
    alignas(64) Values y_{};
    alignas(64) Values distance_{};
    alignas(64) Values gradient_x_{};
    alignas(64) Values gradient_y_{};
    alignas(64) Values smooth_{};
    alignas(64) Values smooth_x_{};
    alignas(64) Values smooth_y_{};
};

// Writes whole vectors of kLanes positions. The last vector may extend beyond the span; the next
// span overwrites the excess.
inline void PixelBatch::add_span(int column, int row, int count) {
    const auto size = static_cast<std::uint32_t>(count);
    spans_[span_count_++] = {column, row, static_cast<std::uint32_t>(count_), size};
    const float x = static_cast<float>(column) - to_middle_x_;
    const float y = static_cast<float>(row) - to_middle_y_;
    for (std::size_t begin = 0; begin < size; begin += kLanes) {
        const float first = x + static_cast<float>(static_cast<int>(begin));
        float* const xs = x_.data() + count_ + begin;
        float* const ys = y_.data() + count_ + begin;
        for (std::size_t k = 0; k < kLanes; ++k) {
            xs[k] = first + static_cast<float>(static_cast<int>(k));
            ys[k] = y;
        }
    }
    count_ += size;
}

}  // namespace foam::texgen
