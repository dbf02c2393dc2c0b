#pragma once

#include "texgen/raster/cell_arcs.h"
#include "texgen/raster/rising_arc.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace foam::texgen {

/// Splits arcs at the borders of pixels, in rows [0, rows).
///
/// An arc's part in a pixel adds its height to all pixels on the right of it; of the pixel itself
/// it leaves out the area on its left. Heights are exact, so that in every row those of a closed
/// chain cancel; where an arc is split depends on it alone, so that whole pixels may move it. Keeps
/// its memory from one arc to the next.
class ArcWalk {
  public:
    /// Parts of neighbouring pixels of a row.
    struct Run {
        std::int32_t row = 0;
        std::size_t begin = 0;  // of its parts
        std::size_t end = 0;    // columns rise from there by 1 or, if `is_leftward`, sink
    };

    explicit ArcWalk(int rows) : top_(rows * kSubpixel) {}

    /// What was split before is forgotten.
    void split(const CellArc& arc, SubpixelPoint translation);

    const std::vector<Run>& runs() const { return runs_; }
    bool is_leftward() const { return is_leftward_; }
    std::int32_t column(std::size_t part) const { return columns_[part]; }
    /// Twice a pixel's width times the part's height, in square subpixels.
    std::int32_t whole(std::size_t part) const { return wholes_[part]; }
    /// Twice the area on the part's left within the pixel, in square subpixels, rounded.
    std::int32_t on_left(std::size_t part) const { return on_left_[part]; }

  private:
    void find_crossings(const RisingArc& arc, SubpixelPoint low, SubpixelPoint high);
    void join_crossings(SubpixelPoint high, std::int32_t first_row);
    void append(std::int32_t column, SubpixelPoint end);
    void measure(double half_curvature);

    std::int32_t top_;  // subpixels
    bool is_leftward_ = false;
    SubpixelPoint from_;            // where the arc enters the rows
    std::vector<std::int32_t> xs_;  // of the crossings with borders of rows, upwards
    std::vector<std::int32_t> ys_;  // of the crossings with borders of columns
    std::vector<Run> runs_;
    // Of each part. One more point than parts: each ends where the next begins.
    std::size_t count_ = 0;
    std::vector<std::int32_t> columns_;
    std::vector<std::int32_t> point_x_;
    std::vector<std::int32_t> point_y_;
    std::vector<std::int32_t> wholes_;
    std::vector<std::int32_t> on_left_;
};

}  // namespace foam::texgen
