// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Splits arcs at the borders of pixels, in the rows [0, rows). Several arcs are split in lockstep,
/// because a single arc would stall on the latency of its square roots.
///
/// The part of an arc in a pixel adds its height to all pixels on its right. In the pixel itself it
/// adds its height minus the area on its left. Heights are exact, so that the heights of a closed
/// chain cancel in every row. The points at which an arc is split depend on the arc alone, so that
/// a shift by whole pixels gives the same parts. Buffers are reused between batches.
class ArcSplitter {
  public:
    static constexpr std::size_t kMaxArcs = 16;

    explicit ArcSplitter(int rows) : rows_(rows) {}

    /// Adds an arc, moved by a translation. Precondition: is_in_rows(arc, translation) and size() <
    /// kMaxArcs.
    void add(const MonotoneArc& arc, SubpixelPoint translation);
    /// Returns true if a part of the arc is in the rows.
    bool is_in_rows(const MonotoneArc& arc, SubpixelPoint translation) const {
        return arc.high.y + translation.y > 0 && arc.low.y + translation.y < rows_ * kSubpixel;
    }

    /// Splits all arcs that were added.
    void split();
    /// Removes all arcs.
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }

    /// The part of an arc in one pixel. Parts without height add nothing.
    struct Part {
        std::int32_t row;
        std::int32_t column;
        /// Twice the width of a pixel times the height of the part, in square subpixels.
        std::int32_t whole;
        /// Twice the area within the pixel to the left of the part, in square subpixels, rounded.
        std::int32_t on_left;
    };
    /// Returns the parts of an arc from its lower end on. Precondition: split() was called.
    std::span<const Part> parts(std::size_t arc) const {
        return std::span(parts_).subspan(arcs_[arc].first_part, arcs_[arc].parts);
    }
    /// Return bounds of the columns of an arc's parts.
    std::int32_t leftmost(std::size_t arc) const { return arcs_[arc].leftmost; }
    std::int32_t rightmost(std::size_t arc) const { return arcs_[arc].rightmost; }

  private:
    // An arc that goes to the left is mirrored, except for `low` and `high`, so that all arcs go to
    // the right.
    struct Arc {
        SubpixelPoint low;
        SubpixelPoint high;
        SubpixelPoint from;       // the point at which the arc enters the rows
        SubpixelPoint to;         // the point at which it leaves them
        std::int32_t sign = 1;    // factor on x: -1 if the arc is mirrored
        std::int32_t bias = 0;    // added to x to find the column: if the arc is mirrored, a border
                                  // belongs to the column before it
        std::int32_t border = 0;  // x of the first border between columns that the arc crosses
        std::int32_t leftmost = 0;
        std::int32_t rightmost = -1;
        float half_curvature = 0.0F;
        std::size_t first_part = 0;
        std::size_t parts = 0;
    };

    static std::int32_t column_of(const Arc& arc, std::int32_t x) { return pixel_of(x + arc.bias); }
    static void measure_arc(const Arc& arc,
                            std::int32_t last_row,
                            const std::int32_t* xs,
                            const std::int32_t* ys,
                            Part* parts);

    void measure_parts();
    void find_columns(std::size_t k);
    void store_row_crossings(std::size_t k);
    void store_column_crossings(std::size_t k);

    std::int32_t rows_;
    std::size_t size_ = 0;
    std::array<Arc, kMaxArcs> arcs_;
    std::array<ArcCrossings, kMaxArcs> row_crossings_;  // crossings of upper borders of rows
    std::array<ArcCrossings, kMaxArcs> column_crossings_;
    std::vector<std::int32_t> xs_;
    std::vector<std::int32_t> ys_;
    // For each border between columns, the number of rows that an arc has left before it crosses
    // the border; 0 if the arc leaves no row between the preceding border and this one. All 0
    // between arcs.
    std::vector<std::int32_t> rows_left_;
    std::vector<std::int32_t> point_x_;  // the start of each part, and the end of the last part
    std::vector<std::int32_t> point_y_;
    std::vector<Part> parts_;
};

}  // namespace foam::texgen
