#pragma once

#include <cstdint>

namespace foam::texgen {

/// How the frames of a sheet lie in it: from left to right, rows from top to bottom. Each has a
/// cell of its own, with a gutter on all four sides. All lengths in pixels.
struct SheetLayout {
    int frames = 1;
    int frame_width = 1;
    int frame_height = 1;
    int columns = 1;
    int gutter = 0;

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

/// The power of two, for sizes of which graphics hardware is fond, that comes nearest to a square
/// sheet; of two that are equally near the larger.
int near_square_columns(int frames, int cell_width, int cell_height);

/// Throws std::invalid_argument for a layout without frames or columns, with a gutter below 0, and
/// for a sheet that is wider or higher than a file can say.
void check_layout(const SheetLayout& layout);

}  // namespace foam::texgen
