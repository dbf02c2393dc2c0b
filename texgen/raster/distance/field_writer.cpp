// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/distance/field_writer.h"

#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <type_traits>

namespace foam::texgen {

namespace {

// Calls visit(begin, size) for pieces that cover [0, count) and may overlap. `size` is a
// compile-time constant, so that the compiler can replace calls of memcpy and fill by a few
// instructions. Most spans are only a few pixels long, and such calls are slow for short spans.
// Precondition: count > 0.
template <class Visit>
[[gnu::always_inline]] inline void in_pieces(std::size_t count, const Visit& visit) {
    constexpr std::integral_constant<std::size_t, 8> kEight;
    constexpr std::integral_constant<std::size_t, 4> kFour;
    constexpr std::integral_constant<std::size_t, 1> kOne;
    if (count >= kEight()) {
        for (std::size_t k = 0; k + kEight() < count; k += kEight()) {
            visit(k, kEight);
        }
        visit(count - kEight(), kEight);
    } else if (count >= kFour()) {
        visit(0, kFour);
        visit(count - kFour(), kFour);
    } else {
        visit(0, kOne);
        visit(count / 2, kOne);
        visit(count - kOne(), kOne);
    }
}

[[gnu::always_inline]] inline void copy_values(const float* from, std::size_t count, float* to) {
    in_pieces(count, [&](std::size_t k, auto size) { std::copy_n(from + k, size(), to + k); });
}

// Copies two arrays into one array of (x, y) pairs.
inline void copy_pairs(const float* xs, const float* ys, std::size_t count, float* to) {
    for (std::size_t k = 0; k < count; ++k) {
        to[2 * k] = xs[k];
        to[2 * k + 1] = ys[k];
    }
}

}  // namespace

// Writes the id and the values of a span of pixels to the images of the field. Precondition: the
// column and the row of the span are in the coordinates of these images, not relative to the box of
// the region.
inline void FieldWriter::write_span(const PixelBatch& batch,
                                    const PixelBatch::Span& span,
                                    std::uint32_t id) {
    const auto pixel = [&](auto& image) { return image.pixel(span.column, span.row).data(); };
    const auto values = [&](const PixelBatch::Values& all_values) {
        return &all_values[span.first];
    };
    std::uint32_t* ids = pixel(field_.ids);
    in_pieces(span.count, [&](std::size_t k, auto size) { std::fill_n(ids + k, size(), id); });
    if (needs_.distance) {
        copy_values(values(batch.distance()), span.count, pixel(field_.distance));
    }
    if (needs_.gradient) {
        copy_pairs(values(batch.gradient_x()),
                   values(batch.gradient_y()),
                   span.count,
                   pixel(field_.gradient));
    }
    if (needs_.smooth != SmoothImages::None) {
        copy_values(values(batch.smooth()), span.count, pixel(field_.smooth));
    }
    if (needs_.smooth == SmoothImages::DistanceAndGradient) {
        copy_pairs(values(batch.smooth_x()),
                   values(batch.smooth_y()),
                   span.count,
                   pixel(field_.smooth_gradient));
    }
}

void FieldWriter::write(const PixelBatch& batch, const PixelBox& box, std::uint32_t id) {
    const int width = field_.ids.width();
    const int left = wrap(box.left, width);
    at_simd_level([this, &batch, bottom = box.bottom, left, width, id] {
        for (PixelBatch::Span span : batch.spans()) {
            span.row += bottom;
            span.column += left;
            while (span.column >= width) {
                span.column -= width;
            }
            for (std::uint32_t rest = span.count; rest > 0; rest -= span.count) {
                span.count = std::min(rest, static_cast<std::uint32_t>(width - span.column));
                write_span(batch, span, id);
                span.first += span.count;
                span.column = 0;
            }
        }
    });
}

}  // namespace foam::texgen
