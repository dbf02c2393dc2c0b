#pragma once

#include "texgen/raster/cell_arcs.h"
#include "texgen/raster/rising_arc.h"

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
    struct Arc {
        SubpixelPoint low;  // of all of it
        SubpixelPoint high;
        SubpixelPoint from;          // where it enters the rows
        std::int32_t direction = 1;  // of its columns
        std::int32_t border = 0;     // the first that it crosses of a column
        std::int32_t leftmost = 0;
        std::int32_t rightmost = -1;
        float half_curvature = 0.0F;
        std::size_t first_part = 0;
        std::size_t parts = 0;
    };

    void end_rows(std::size_t k);
    void join_crossings(std::size_t k);

    std::int32_t rows_;
    std::size_t size_ = 0;
    std::array<Arc, kMostArcs> arcs_;
    std::array<ArcCrossings, kMostArcs> row_crossings_;  // where an arc leaves each row, upwards
    std::array<ArcCrossings, kMostArcs> column_crossings_;
    std::vector<std::int32_t> xs_;
    std::vector<std::int32_t> ys_;
    std::vector<std::int32_t> point_x_;  // where each part begins, and the last one ends
    std::vector<std::int32_t> point_y_;
    std::vector<Part> parts_;
};

}  // namespace foam::texgen
