// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/parallel/kernel_array.h"
#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Splits arcs into one part per pixel, in the rows [0, rows). Up to kMaxArcs arcs are split in
/// lockstep, because a single arc would stall on the latency of its square roots. Heights of parts
/// are exact, so that the signed heights of a closed chain cancel in every row. The points at which
/// an arc is split depend on the arc alone. Buffers are reused between batches of arcs.
class ArcSplitter {
  public:
    static constexpr std::size_t kMaxArcs = 16;  // largest number of arcs in a batch

    explicit ArcSplitter(int rows) : rows_(rows) {}

    /// Adds an arc, moved by a translation, to the batch. Preconditions: is_in_rows(arc,
    /// translation), and size() < kMaxArcs.
    void add(const MonotoneArc& arc, SubpixelPoint translation);
    /// Returns true if a part of the arc, moved by a translation, is in the rows.
    bool is_in_rows(const MonotoneArc& arc, SubpixelPoint translation) const {
        return arc.high.y + translation.y > 0 && arc.low.y + translation.y < rows_ * kSubpixel;
    }

    /// Splits all arcs of the batch.
    void split();
    /// Removes all arcs from the batch.
    void clear() { size_ = 0; }

    /// Returns the number of arcs in the batch.
    std::size_t size() const { return size_; }

    /// The part of an arc in one pixel. If its height is 0, both areas are 0.
    struct Part {
        std::int32_t row;
        std::int32_t column;
        /// Twice the area, in square subpixels, of a rectangle that is as wide as a pixel and as
        /// high as the part.
        std::int32_t twice_area;
        /// Twice the area, in square subpixels, of the part of this rectangle that is on the left
        /// of the arc, rounded.
        std::int32_t twice_area_on_left;
    };
    /// Returns the parts of an arc, starting at its lower end. Arcs are numbered in the order in
    /// which they were added. Precondition: split() was called.
    std::span<const Part> parts(std::size_t arc) const {
        return std::span(parts_).subspan(arcs_[arc].first_part, arcs_[arc].parts);
    }
    /// Return a lower and an upper bound of the columns of the parts of an arc.
    std::int32_t leftmost(std::size_t arc) const { return arcs_[arc].leftmost; }
    std::int32_t rightmost(std::size_t arc) const { return arcs_[arc].rightmost; }

  private:
    // An arc whose upper end is on the left of its lower end is mirrored in x, so that all arcs go
    // to the right. `low`, `high`, `leftmost`, `rightmost` and `half_curvature` are not mirrored.
    struct Arc {
        SubpixelPoint low;
        SubpixelPoint high;
        SubpixelPoint from;       // the lower end of the arc within the rows
        SubpixelPoint to;         // the upper end of the arc within the rows
        std::int32_t sign = 1;    // factor on x: -1 if the arc is mirrored, else 1
        std::int32_t bias = 0;    // see column_of
        std::int32_t border = 0;  // x of the first border between columns that the arc crosses
        std::int32_t leftmost = 0;
        std::int32_t rightmost = -1;
        float half_curvature = 0.0F;  // per subpixel; positive if the arc turns left
        std::size_t first_part = 0;
        std::size_t parts = 0;
    };

    // Returns the column of pixels that contains the x coordinate of a point of an arc, or minus
    // this column if the arc and x are mirrored. A point on a border between columns belongs to the
    // column on its right in the image. To achieve this for a mirrored arc, its bias makes pixel_of
    // round up.
    static std::int32_t column_of(const Arc& arc, std::int32_t x) { return pixel_of(x + arc.bias); }
    void measure_parts();
    void find_columns(std::size_t k);
    void store_row_crossings(std::size_t k);
    void store_column_crossings(std::size_t k);

    std::int32_t rows_;
    std::size_t size_ = 0;
    KernelArray<Arc, kMaxArcs> arcs_;
    // The queries for crossings with the upper borders of rows.
    KernelArray<CrossingQuery, kMaxArcs> row_queries_;
    // The queries for crossings with the borders between columns.
    KernelArray<CrossingQuery, kMaxArcs> column_queries_;
    std::vector<std::int32_t> xs_;  // results of row_queries_
    std::vector<std::int32_t> ys_;  // results of column_queries_
    // Scratch array for the arc that is being processed; between arcs, all elements are 0. The
    // columns of pixels through which the arc passes are numbered from 0, in its direction. Element
    // k is 0 if the arc crosses no border between rows within column k. Otherwise it is the number
    // of borders between rows that the arc has crossed when it leaves column k.
    std::vector<std::int32_t> rows_crossed_;
    // The start of each part of each arc, and the end of the last part of each arc. The points of a
    // mirrored arc are mirrored.
    std::vector<std::int32_t> point_x_;
    std::vector<std::int32_t> point_y_;
    std::vector<Part> parts_;
};

}  // namespace foam::texgen
