// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/pixel_contrast.h"

#include "core/parallel/simd_level.h"
#include "texgen/maps/map_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace foam::texgen {

namespace {

// The brightnesses of a row of pixels (`padded`) and of the rows below and above it, and the
// distances of the row's pixels from films or walls. `padded` begins with the left neighbor of the
// row's first pixel, and ends with the right neighbor of the row's last pixel.
struct ContrastRow {
    const float* padded;
    const float* below;
    const float* above;
    const float* distances;
};

// Sets marks[k] to 1 if pixel k of the row needs several samples, otherwise to 0. A pixel needs
// several samples if a film or wall is near. It also needs them if its brightness differs too much
// from the mean of its two neighbors in the row or in the column.
void mark_contrasts(const ContrastRow& row, std::vector<std::uint8_t>& marks) {
    at_simd_level([row, count = marks.size(), to = marks.data()] {
        constexpr float kContrast = 0.025F;  // smallest relative difference
        constexpr float kDark =
            0.1F * static_cast<float>(kWhite);  // reduces the relative differences of dark pixels
        constexpr float kNear = 1.0F;           // pixels
        for (std::size_t k = 0; k < count; ++k) {
            const float middle = row.padded[k + 1];
            const float limit = kContrast * (middle + kDark);
            const float row_difference = 0.5F * (row.padded[k] + row.padded[k + 2]) - middle;
            const float column_difference = 0.5F * (row.below[k] + row.above[k]) - middle;
            const auto is_near = static_cast<unsigned>(row.distances[k] < kNear);
            const auto differs_in_row = static_cast<unsigned>(std::abs(row_difference) > limit);
            const auto differs_in_column =
                static_cast<unsigned>(std::abs(column_difference) > limit);
            to[k] = static_cast<std::uint8_t>(is_near | differs_in_row | differs_in_column);
        }
    });
}

}  // namespace

std::vector<std::uint32_t> find_contrasts(std::span<const float> brightness,
                                          std::span<const float> distances,
                                          const PixelNeighbors& neighbors) {
    const std::size_t width = neighbors.width();
    std::vector<float> padded(width + 2);
    std::vector<std::uint8_t> marks(width);
    std::vector<std::uint32_t> pixels;
    for (std::size_t first = 0; first < brightness.size(); first += width) {
        const auto row = brightness.subspan(first, width);
        padded.front() = brightness[neighbors.left(first)];
        std::ranges::copy(row, padded.begin() + 1);
        padded.back() = brightness[neighbors.right(first + width - 1)];
        mark_contrasts({padded.data(),
                        &brightness[neighbors.below(first)],
                        &brightness[neighbors.above(first)],
                        &distances[first]},
                       marks);
        for (std::size_t k = 0; k < width; ++k) {
            if (marks[k] != 0) {
                pixels.push_back(static_cast<std::uint32_t>(first + k));
            }
        }
    }
    return pixels;
}

}  // namespace foam::texgen
