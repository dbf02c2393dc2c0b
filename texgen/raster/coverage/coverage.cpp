// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/coverage.h"

#include "texgen/raster/coords/raster_grid.h"

// The method is the accumulation of signed areas. Each edge adds its signed areas to the pixels
// that it crosses. A running sum along the row extends the area of the edge to all pixels on its
// right. LibArt (R. Levien, 1998), the smooth rasterizer of FreeType (D. Turner, ftgrays.c, 2000)
// and font-rs (R. Levien, 2016) fill outlines in this way. These programs fill one shape with one
// color, and their edges are line segments. Here the edges are arcs. Each area is multiplied by the
// change of a value across the arc, so that one pass fills all bubbles. On a torus, it also fills
// their periodic copies. These extensions are our own.

namespace foam::texgen {

template <std::size_t Channels>
Coverage<Channels>::Coverage(int width, int rows, RowKind kind)
    : width_(width),
      kind_(kind),
      splitter_(rows),
      rows_(static_cast<std::size_t>(rows)),
      cells_(static_cast<std::size_t>(width) + 1),
      touched_(static_cast<std::size_t>(width) / kFlagsPerWord + 1),
      begins_(static_cast<std::size_t>(width) + 1 + kFlagsPerStep) {}

template <std::size_t Channels>
void Coverage<Channels>::clear() {
    splitter_.clear();
    across_.clear();
    for (Row& row : rows_) {
        row.parts.clear();
        row.start = {};
    }
}

template <std::size_t Channels>
void Coverage<Channels>::add(const MonotoneArc& arc, SubpixelPoint translation, const Step& step) {
    if (!splitter_.is_in_rows(arc, translation)) {
        return;
    }
    steps_[splitter_.size()] = step;
    splitter_.add(arc, translation);
    if (splitter_.size() == ArcSplitter::kMaxArcs) {
        finish();
    }
}

template <std::size_t Channels>
void Coverage<Channels>::finish() {
    splitter_.split();
    for (std::size_t k = 0; k < splitter_.size(); ++k) {
        add_parts(k);
        if (steps_[k].wraps) [[unlikely]] {
            for (const ArcSplitter::Part& part : splitter_.parts(k)) {
                Sums& start = rows_[static_cast<std::size_t>(part.row)].start;
                add_times(-part.twice_area, steps_[k].period_correction, start);
            }
        }
    }
    splitter_.clear();
}

// Stores the parts of a pending arc in their rows.
template <std::size_t Channels>
void Coverage<Channels>::add_parts(std::size_t k) {
    const auto arc = static_cast<std::uint32_t>(across_.size());
    across_.push_back(steps_[k].across);
    const bool is_inside = splitter_.leftmost(k) >= 0 && splitter_.rightmost(k) < width_;
    // A pointer, because std::vector checks indices in hardened builds.
    Row* const rows = rows_.data();
    for (const ArcSplitter::Part& part : splitter_.parts(k)) {
        Row& row = rows[part.row];
        if (is_inside) [[likely]] {
            row.parts.push_back({part.column, part.twice_area, part.twice_area_on_left, arc});
        } else {
            add_outside(part, arc, row);
        }
    }
}

// Adds a part of an arc. The arc may extend beyond the left or right border of the image. The part
// itself may be within the columns of the image, on their left or on their right. The comment of
// the class Coverage explains what a part on their left or on their right contributes.
template <std::size_t Channels>
void Coverage<Channels>::add_outside(const ArcSplitter::Part& part, std::uint32_t arc, Row& row) {
    const std::int32_t periods = floor_div(part.column, width_);
    const bool is_ring = kind_ == RowKind::Ring;
    const std::int32_t times = is_ring ? -periods : periods < 0 ? 1 : 0;
    add_times(static_cast<double>(times) * part.twice_area, across_[arc], row.start);
    if (is_ring || periods == 0) {
        row.parts.push_back(
            {part.column - periods * width_, part.twice_area, part.twice_area_on_left, arc});
    }
}

template class Coverage<1>;
template class Coverage<2>;
template class Coverage<3>;
template class Coverage<4>;

}  // namespace foam::texgen
