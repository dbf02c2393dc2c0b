#pragma once

#include "texgen/raster/arcs/arc_crossings.h"
#include "texgen/raster/arcs/monotone_arc.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foam::texgen {

/// Splits arcs at the borders of pixels, in rows [0, rows). Several arcs are split in lockstep: one
/// alone would spend its time waiting for square roots.
///
/// The part of an arc in a pixel adds its height to all pixels on its right, and in the pixel
/// itself all but the area on its left. Heights are exact, so that in every row those of a closed
/// chain cancel; where an arc is split depends on the arc alone, so that whole pixels may move it.
/// Buffers are reused between batches.
class ArcWalk {
  public:
    static constexpr std::size_t kMaxArcs = 16;

    explicit ArcWalk(int rows) : rows_(rows) {}

    /// Adds an arc. Precondition: part of it is in the rows, and size() < kMaxArcs.
    void add(const MonotoneArc& arc, SubpixelPoint translation);
    bool is_in_rows(const MonotoneArc& arc, SubpixelPoint translation) const {
        return arc.high.y + translation.y > 0 && arc.low.y + translation.y < rows_ * kSubpixel;
    }

    /// Splits all arcs that were added.
    void split();
    void clear() { size_ = 0; }

    std::size_t size() const { return size_; }

    /// The part of an arc in one pixel. Some have no height, and add nothing.
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
    /// Bounds of the columns of an arc's parts.
    std::int32_t leftmost(std::size_t arc) const { return arcs_[arc].leftmost; }
    std::int32_t rightmost(std::size_t arc) const { return arcs_[arc].rightmost; }

  private:
    // An arc that goes to the left is mirrored, except for its ends, so that all go to the right.
    struct Arc {
        SubpixelPoint low;
        SubpixelPoint high;
        SubpixelPoint from;  // where it enters and leaves the rows
        SubpixelPoint to;
        std::int32_t sign = 1;  // of x: -1 if it is mirrored
        std::int32_t bias =
            0;  // of x, for its column: a mirrored border belongs to the column before it
        std::int32_t border = 0;  // the first border between columns that it crosses
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
    void place_rows(std::size_t k);
    void place_columns(std::size_t k);

    std::int32_t rows_;
    std::size_t size_ = 0;
    std::array<Arc, kMaxArcs> arcs_;
    std::array<ArcCrossings, kMaxArcs> row_crossings_;  // where an arc leaves each row, upwards
    std::array<ArcCrossings, kMaxArcs> column_crossings_;
    std::vector<std::int32_t> xs_;
    std::vector<std::int32_t> ys_;
    // Per border between columns, the number of rows that an arc leaves before it; 0 if no more
    // than before the last border, and between arcs.
    std::vector<std::int32_t> rows_left_;
    std::vector<std::int32_t> point_x_;  // where each part begins, and the last one ends
    std::vector<std::int32_t> point_y_;
    std::vector<Part> parts_;
};

}  // namespace foam::texgen
