// SPDX-License-Identifier: Apache-2.0

#include "texgen/sheet/layout.h"

#include "core/files/input_limits.h"
#include "core/geometry/elementary.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace foam::texgen {

namespace {

// Returns a measure of how far a sheet is from a square, which has the measure 0. The measure is
// the absolute value of the binary logarithm of the aspect ratio.
double distance_from_square(int frames, int columns, double cell_width, double cell_height) {
    const double rows = std::ceil(static_cast<double>(frames) / columns);
    return std::abs(ieee::log2(columns * cell_width / (rows * cell_height)));
}

}  // namespace

int near_square_columns(int frames, int cell_width, int cell_height) {
    int best = 1;
    double smallest = distance_from_square(frames, best, cell_width, cell_height);
    for (int columns = 2; columns / 2 < frames; columns *= 2) {
        const double distance = distance_from_square(frames, columns, cell_width, cell_height);
        if (distance <= smallest) {
            best = columns;
            smallest = distance;
        }
    }
    return best;
}

void check_layout(const SheetLayout& layout) {
    const int smallest =
        std::min({layout.frames, layout.columns, layout.frame_width, layout.frame_height});
    if (smallest < 1 || layout.gutter < 0) {
        throw std::invalid_argument(
            fmt::format("a sheet needs at least one frame, one column, one pixel per frame and a "
                        "gutter of 0 or more, but has {} frames of {} x {} pixels in {} columns "
                        "and a gutter of {}",
                        layout.frames,
                        layout.frame_width,
                        layout.frame_height,
                        layout.columns,
                        layout.gutter));
    }
    // The limits of lengths are compared first, so that the product of width and height does not
    // overflow.
    if (layout.gutter > kMaxImageExtent || layout.width() > kMaxImageExtent ||
        layout.height() > kMaxImageExtent || layout.width() * layout.height() > kMaxImagePixels) {
        throw std::invalid_argument(
            fmt::format("a sheet of {} x {} pixels is too large: an image may have at most {} "
                        "pixels per side and {} pixels",
                        layout.width(),
                        layout.height(),
                        kMaxImageExtent,
                        kMaxImagePixels));
    }
}

}  // namespace foam::texgen
