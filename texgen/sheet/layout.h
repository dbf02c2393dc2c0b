// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>

namespace foam::texgen {

/// The layout of frames in a sheet, an image that contains many frames. Frames are ordered from
/// left to right, in rows from top to bottom. Each frame has a cell, which also contains a gutter
/// on all four sides of the frame. All lengths are in pixels.
struct SheetLayout {
    int frames = 1;  // number of frames
    int frame_width = 1;
    int frame_height = 1;
    int columns = 1;
    int gutter = 0;  // width of the border around each frame

    int rows() const { return (frames + columns - 1) / columns; }
    int cell_width() const { return frame_width + 2 * gutter; }
    int cell_height() const { return frame_height + 2 * gutter; }
    std::int64_t width() const {
        return columns * (std::int64_t{frame_width} + 2 * std::int64_t{gutter});
    }
    std::int64_t height() const {
        return rows() * (std::int64_t{frame_height} + 2 * std::int64_t{gutter});
    }

    friend bool operator==(const SheetLayout&, const SheetLayout&) = default;
};

/// Returns the number of columns, a power of two, for which a sheet is most nearly square. If two
/// powers are equally good, returns the larger one. If the width of a cell is a power of two, the
/// width of the sheet is one, too. Graphics hardware prefers such widths.
int near_square_columns(int frames, int cell_width, int cell_height);

/// Throws std::invalid_argument if a layout has no frames, no columns or no pixels, or if its
/// gutter is negative. Also throws std::invalid_argument if the sheet would be too large for an
/// image (kMaxImageExtent and kMaxImagePixels in core/files/input_limits.h).
void check_layout(const SheetLayout& layout);

}  // namespace foam::texgen
