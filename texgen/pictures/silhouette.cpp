// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/silhouette.h"

#include "texgen/pictures/traced_outlines.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

constexpr double kLevel = 0.5;

bool has_transparent_part(const SourcePicture& picture) {
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            if (pixel_of(picture, x, y).opacity < kLevel) {
                return true;
            }
        }
    }
    return false;
}

// Outlines are traced on a grid of numbers (grid_of). Each number is the mean over a square of
// pixels. Returns the side of these squares, in pixels.
int block_size(const SourcePicture& picture) {
    const double pixels = static_cast<double>(picture.width()) * picture.height();
    return std::max(1, static_cast<int>(std::ceil(std::sqrt(pixels / kOutlineGridPoints))));
}

template <class Number>
Image<float> grid_of(const SourcePicture& picture, const Number& number) {
    const int size = block_size(picture);
    Image<float> grid((picture.width() + size - 1) / size, (picture.height() + size - 1) / size, 1);
    for (int y = 0; y < grid.height(); ++y) {
        for (int x = 0; x < grid.width(); ++x) {
            const PixelRect box{x * size,
                                y * size,
                                std::min((x + 1) * size, picture.width()),
                                std::min((y + 1) * size, picture.height())};
            grid.pixel(x, y)[0] = static_cast<float>(mean_over(picture, box, number));
        }
    }
    return grid;
}

}  // namespace

std::vector<foam::Outline> silhouette(const SourcePicture& picture) {
    const auto opacity = [](const SourcePixel& pixel) { return pixel.opacity; };
    const auto darkness = [](const SourcePixel& pixel) {
        return 1.0 - linear_to_srgb(luminance_of(color_on_white(pixel)));
    };
    return traced_outlines(
        has_transparent_part(picture) ? grid_of(picture, opacity) : grid_of(picture, darkness),
        kLevel);
}

}  // namespace foam::texgen
