// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/display_frame.h"

#include "texgen/image/color.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace foam::texgen {

namespace {

constexpr float kMaxCode = 255.0F;

// The pixels along one axis that a pixel of the smaller image covers. `first` is the index of the
// first covered pixel. `weights` contains the weights of all covered pixels, which add up to 1.
struct Cover {
    int first = 0;
    std::vector<float> weights;
};

// Returns the Cover of each of the `few` pixels to which the `many` pixels along an axis are
// reduced.
std::vector<Cover> covers_of(int many, int few) {
    const double scale = static_cast<double>(many) / few;
    std::vector<Cover> covers(static_cast<std::size_t>(few));
    for (int k = 0; k < few; ++k) {
        const double begin = k * scale;
        const double end = k + 1 < few ? (k + 1) * scale : many;
        Cover& cover = covers[static_cast<std::size_t>(k)];
        cover.first = static_cast<int>(begin);
        for (int pixel = cover.first; pixel < end; ++pixel) {
            const double part = std::min(end, pixel + 1.0) - std::max<double>(begin, pixel);
            cover.weights.push_back(static_cast<float>(part / scale));
        }
    }
    return covers;
}

// Computes the weighted mean of the covered rows, sample by sample, and writes it to `mean`.
void average_rows(ImageView<const float> from, const Cover& cover, std::vector<float>& mean) {
    std::ranges::fill(mean, 0.0F);
    for (std::size_t k = 0; k < cover.weights.size(); ++k) {
        const auto row = from.row(cover.first + static_cast<int>(k));
        for (std::size_t i = 0; i < mean.size(); ++i) {
            mean[i] += cover.weights[k] * row[i];
        }
    }
}

// Adds the weighted mean of the covered pixels of a row to the pixel `mean`.
void add_pixels(const std::vector<float>& row, const Cover& cover, std::span<float> mean) {
    const float* from = row.data() + static_cast<std::size_t>(cover.first) * DisplayFrame::kColors;
    for (const float weight : cover.weights) {
        for (float& sum : mean) {
            sum += weight * *from++;
        }
    }
}

}  // namespace

DisplayFrame reduced(const DisplayFrame& frame, int width, int height) {
    const ImageView<const float> from = frame.pixels.view();
    assert(width <= from.width() && height <= from.height());
    DisplayFrame smaller{Image<float>(width, height, DisplayFrame::kColors), frame.is_light};
    const std::vector<Cover> rows = covers_of(from.height(), height);
    const std::vector<Cover> columns = covers_of(from.width(), width);
    std::vector<float> mean(from.row_samples());
    for (int y = 0; y < height; ++y) {
        average_rows(from, rows[static_cast<std::size_t>(y)], mean);
        for (int x = 0; x < width; ++x) {
            add_pixels(mean, columns[static_cast<std::size_t>(x)], smaller.pixels.pixel(x, y));
        }
    }
    return smaller;
}

Image<std::uint8_t> codes_of(const DisplayFrame& frame) {
    Image<std::uint8_t> codes(frame.pixels.width(), frame.pixels.height(), DisplayFrame::kColors);
    std::ranges::transform(
        frame.pixels.samples(), codes.samples().begin(), [&](float value) -> std::uint8_t {
            const double clamped = std::clamp(value, 0.0F, 1.0F);
            const double code = frame.is_light ? linear_to_srgb(clamped) : clamped;
            return static_cast<std::uint8_t>(std::lround(kMaxCode * code));
        });
    return codes;
}

}  // namespace foam::texgen
