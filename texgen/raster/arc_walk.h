#pragma once

#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/cell_arcs.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Splits arcs at the borders of pixels, in rows [0, rows); several together, as one would spend
/// its time waiting for roots.
///
/// An arc's part in a pixel adds its height to all pixels on the right of it; of the pixel itself
/// it leaves out the area on its left. Heights are exact, so that in every row those of a closed
/// chain cancel; where an arc is split depends on it alone, so that whole pixels may move it. Keeps
/// its memory from one time to the next.
class ArcWalk {
  public:
    static constexpr std::size_t kMostArcs = 16;

    explicit ArcWalk(int rows) : rows_(rows) {}

    /// Takes one more arc, of which some part lies in the rows; kMostArcs at most.
    void add(const CellArc& arc, SubpixelPoint translation);
    bool is_in_rows(const CellArc& arc, SubpixelPoint translation) const {
        return arc.high.y + translation.y > 0 && arc.low.y + translation.y < rows_ * kSubpixel;
    }

    /// Splits all arcs that were added.
    void split();
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }

    /// Where a part lies, and what it adds up to. Some have no height, and add nothing.
    struct Part {
        std::int32_t row;
        std::int32_t column;
        /// Twice a pixel's width times the part's height, in square subpixels.
        std::int32_t whole;
        /// Twice the area on the part's left within the pixel, in square subpixels, rounded.
        std::int32_t on_left;
    };
    std::span<const Part> parts(std::size_t arc) const {
        return std::span(parts_).subspan(arcs_[arc].first_part, arcs_[arc].parts);
    }
    /// No part of an arc lies further left, or right.
    std::int32_t leftmost(std::size_t arc) const { return arcs_[arc].leftmost; }
    std::int32_t rightmost(std::size_t arc) const { return arcs_[arc].rightmost; }

  private:
    // But for its ends, an arc that goes to the left is mirrored, so that all of them go to the
    // right.
    struct Arc {
        SubpixelPoint low;
        SubpixelPoint high;
        SubpixelPoint from;  // where it enters the rows, and where it leaves them
        SubpixelPoint to;
        std::int32_t sign = 1;    // of x: -1 if it is mirrored
        std::int32_t bias = 0;    // of x, for its column: a mirrored border is of the one before it
        std::int32_t border = 0;  // the first that it crosses of a column
        std::int32_t leftmost = 0;
        std::int32_t rightmost = -1;
        float half_curvature = 0.0F;
        std::size_t first_part = 0;
        std::size_t parts = 0;
    };

    static std::int32_t column_of(const Arc& arc, std::int32_t x) { return pixel_of(x + arc.bias); }
    static void measure_parts(std::span<const Arc> arcs,
                              std::int32_t last_row,
                              const std::int32_t* xs,
                              const std::int32_t* ys,
                              Part* parts);

    void find_columns(std::size_t k);
    void place_rows(std::size_t k);
    void place_columns(std::size_t k);

    std::int32_t rows_;
    std::size_t size_ = 0;
    std::array<Arc, kMostArcs> arcs_;
    std::array<ArcCrossings, kMostArcs> row_crossings_;  // where an arc leaves each row, upwards
    std::array<ArcCrossings, kMostArcs> column_crossings_;
    std::vector<std::int32_t> xs_;
    std::vector<std::int32_t> ys_;
    // Of each border of columns, how many rows an arc leaves before it; 0 if as many as before the
    // last border, and between arcs.
    std::vector<std::int32_t> rows_left_;
    std::vector<std::int32_t> point_x_;  // where each part begins, and the last one ends
    std::vector<std::int32_t> point_y_;
    std::vector<Part> parts_;
};

}  // namespace foam::texgen
