#include "texgen/raster/field_writer.h"

#include <algorithm>
#include <cstddef>

namespace foam::texgen {

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
void FieldWriter::expect(ImagePlace place, int columns, int first_row, int rows) const {
    constexpr int kStep = 16;
    const int width = field_.ids.width();
    for (int row = std::max(first_row, -place.row); row < first_row + rows; ++row) {
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
    std::fill_n(field_.ids.pixel(at.x, at.row).data(), at.count, id);
    const auto copy_one = [&](const PixelBatch::Values& values, Image<float>& image) {
        std::copy_n(&values[at.first], at.count, image.pixel(at.x, at.row).data());
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
