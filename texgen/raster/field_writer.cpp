#include "texgen/raster/field_writer.h"

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace foam::texgen {

namespace {

// Calls visit(begin, size) for pieces of [0, count) that may overlap: of sizes that compilers know,
// as runs are mostly a few pixels long. Precondition: count is not 0.
template <class Visit>
void in_pieces(std::size_t count, const Visit& visit) {
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

}  // namespace

void FieldWriter::write(const PixelBatch& batch, ImagePlace place, std::uint32_t id) {
    const int width = field_.ids.width();
    for (const PixelBatch::Run& run : batch.runs()) {
        int x = place.x + run.column;
        while (x >= width) {
            x -= width;
        }
        write_run(batch, {place.row + run.row, x, run.first, run.count}, id);
    }
}

// A cache line is as wide as 16 pixels. Written rows lie a whole image row apart, which processors
// do not foresee.
void FieldWriter::expect(ImagePlace place, int columns, int begin, int end) const {
    constexpr int kStep = 16;
    const int width = field_.ids.width();
    for (int row = begin; row < end; ++row) {
        for (int column = 0; column < columns; column += kStep) {
            const int x = place.x + column;
            if (x < width) {
                __builtin_prefetch(field_.ids.pixel(x, place.row + row).data(), 1, 2);
                __builtin_prefetch(field_.distance.pixel(x, place.row + row).data(), 1, 2);
            }
        }
    }
}

// Around a torus in two pieces or more.
void FieldWriter::write_run(const PixelBatch& batch, Pixels at, std::uint32_t id) {
    const auto width = static_cast<std::size_t>(field_.ids.width());
    for (std::size_t left = at.count; left > 0; left -= at.count) {
        at.count = std::min(left, width - static_cast<std::size_t>(at.x));
        write_pixels(batch, at, id);
        at.first += at.count;
        at.x = 0;
    }
}

void FieldWriter::write_pixels(const PixelBatch& batch, const Pixels& at, std::uint32_t id) {
    std::uint32_t* ids = field_.ids.pixel(at.x, at.row).data();
    in_pieces(at.count, [&](std::size_t k, auto size) { std::fill_n(ids + k, size(), id); });
    const auto copy_one = [&](const PixelBatch::Values& values, Image<float>& image) {
        const float* from = &values[at.first];
        float* to = image.pixel(at.x, at.row).data();
        in_pieces(at.count,
                  [&](std::size_t k, auto size) { std::copy_n(from + k, size(), to + k); });
    };
    const auto copy_two =
        [&](const PixelBatch::Values& xs, const PixelBatch::Values& ys, Image<float>& image) {
            float* sample = image.pixel(at.x, at.row).data();
            for (std::size_t k = at.first; k < at.first + at.count; ++k) {
                *sample++ = xs[k];
                *sample++ = ys[k];
            }
        };
    copy_one(batch.distance(), field_.distance);
    if (needs_.gradient) {
        copy_two(batch.gradient_x(), batch.gradient_y(), field_.gradient);
    }
    if (needs_.smooth) {
        copy_one(batch.smooth(), field_.smooth);
        copy_two(batch.smooth_x(), batch.smooth_y(), field_.smooth_gradient);
    }
}

}  // namespace foam::texgen
