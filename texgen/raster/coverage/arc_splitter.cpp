// SPDX-License-Identifier: Apache-2.0

#include "texgen/raster/coverage/arc_splitter.h"

#include "texgen/raster/arcs/pixel_arc.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

// Like the rasterizers that coverage.cpp names, this class cuts edges at the borders of pixels.
// FreeType, for example, flattens a curve and follows each line segment from pixel to pixel. Here
// the crossings of an arc are roots of quadratic equations (arc_crossings.h), so that they are
// computed independently of each other in vectorized loops. The rest of the method is our own.
//
// First the crossings of an arc with borders between rows are computed, then its crossings with
// borders between columns. The two sequences are merged. The index of a crossing in the merged
// sequence is its index in its own sequence plus the number of crossings of the other kind before
// it. For a crossing with a border between rows, this number follows from the column of the
// crossing. For a crossing with a border between columns, it is the number of borders between rows
// that the arc has crossed before. The function store_row_crossings records this number by column
// in `rows_crossed_`. No two crossings are compared, so the merge has no unpredictable branches.

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = 16;  // number of parts whose areas are computed at once

}  // namespace

void ArcSplitter::add(const MonotoneArc& arc, SubpixelPoint translation) {
    const SubpixelPoint low = arc.low + translation;
    const SubpixelPoint high = arc.high + translation;
    const SubpixelPoint chord = high - low;
    const RoundedCrossings rising(chord, arc.sine);
    const std::int32_t from = low.y < 0 ? low.x + rising.x_at(-low.y) : low.x;
    const std::size_t k = size_++;
    Arc& own = arcs_[k];
    own.low = low;
    own.high = high;
    own.sign = chord.x < 0 ? -1 : 1;
    own.bias = chord.x < 0 ? kSubpixel - 1 : 0;
    own.from = {own.sign * from, std::max(low.y, 0)};
    own.to = {own.sign * high.x, std::min(high.y, rows_ * kSubpixel)};
    own.half_curvature = static_cast<float>(arc.sine / Vec2(chord.x, chord.y).norm());
    const std::int32_t row = pixel_of(own.from.y);
    row_queries_[k] = {rising,
                       (row + 1) * kSubpixel - low.y,
                       kSubpixel,
                       low.x,
                       own.sign,
                       static_cast<std::size_t>(pixel_of(own.to.y - 1) - row) + 1,
                       k == 0 ? 0 : row_queries_[k - 1].end()};
}

// Completes each stage for all arcs before the next stage, so that the processor computes square
// roots of different arcs at the same time.
void ArcSplitter::split() {
    if (size_ == 0) {
        return;
    }
    grow(xs_, row_queries_[size_ - 1].end());
    find_xs(std::span(row_queries_).first(size_), xs_.data());
    for (std::size_t k = 0; k < size_; ++k) {
        find_columns(k);
    }
    grow(ys_, column_queries_[size_ - 1].end());
    find_ys(std::span(column_queries_).first(size_), ys_.data());
    const std::size_t points = arcs_[size_ - 1].first_part + arcs_[size_ - 1].parts + 1 + kLanes;
    grow(point_x_, points);
    grow(point_y_, points);
    grow(parts_, points);
    grow(rows_crossed_, points);
    for (std::size_t k = 0; k < size_; ++k) {
        store_row_crossings(k);
        store_column_crossings(k);
    }
    measure_parts();
}

// Determines which borders between columns an arc crosses. If the arc leaves the rows at the top,
// also corrects the x of Arc::to. The function `add` has set this x to that of the upper end of the
// whole arc.
void ArcSplitter::find_columns(std::size_t k) {
    Arc& arc = arcs_[k];
    const CrossingQuery& rows = row_queries_[k];
    if (arc.high.y > arc.to.y) {
        arc.to.x = std::max(arc.from.x, xs_[rows.position + rows.count - 1]);
    }
    const std::int32_t first_column = column_of(arc, arc.from.x);
    const std::int32_t last_column = column_of(arc, arc.to.x);
    const bool is_mirrored = arc.sign < 0;
    arc.leftmost = is_mirrored ? -last_column : first_column;
    arc.rightmost = is_mirrored ? -first_column : last_column;
    arc.border = (is_mirrored ? first_column : first_column + 1) * kSubpixel;
    const auto columns = static_cast<std::size_t>(last_column - first_column);
    column_queries_[k] = {rows.arc,
                          arc.sign * arc.border - arc.low.x,
                          arc.sign * kSubpixel,
                          arc.low.y,
                          1,
                          columns,
                          k == 0 ? 0 : column_queries_[k - 1].end()};
    arc.parts = rows.count + columns;
    arc.first_part = k == 0 ? 0 : arcs_[k - 1].first_part + arcs_[k - 1].parts + 1;
}

// Stores the points at which an arc crosses from row to row, and leaves array elements free for the
// crossings with borders between columns. `std::min` and `std::max` ensure that x never decreases
// from one point to the next, in spite of rounding.
void ArcSplitter::store_row_crossings(std::size_t k) {
    const Arc arc = arcs_[k];  // a copy, which the stores below cannot change
    const CrossingQuery& rows = row_queries_[k];
    const std::int32_t* xs = &xs_[rows.position];
    const std::int32_t first_column = column_of(arc, arc.from.x);
    std::int32_t* rows_crossed = rows_crossed_.data();
    std::int32_t* point_x = &point_x_[arc.first_part];
    std::int32_t* point_y = &point_y_[arc.first_part];
    point_x[0] = arc.from.x;
    point_y[0] = arc.from.y;
    point_x[arc.parts] = arc.to.x;
    point_y[arc.parts] = arc.to.y;
    const std::int32_t first_row = pixel_of(arc.from.y);
    const auto last = static_cast<std::int32_t>(rows.count) - 1;
    std::int32_t x = arc.from.x;
    for (std::int32_t row = 0; row < last;) {
        x = std::min(std::max(x, xs[row]), arc.to.x);
        const std::int32_t columns = column_of(arc, x) - first_column;
        ++row;
        point_x[row + columns] = x;
        point_y[row + columns] = (first_row + row) * kSubpixel;
        rows_crossed[columns] = row;
    }
}

// Stores the crossings of an arc with borders between columns in the elements left free. The y of
// each crossing is clamped to the row in which the arc crosses the border.
void ArcSplitter::store_column_crossings(std::size_t k) {
    const Arc& arc = arcs_[k];
    const CrossingQuery& columns = column_queries_[k];
    const std::int32_t* ys = ys_.data() + columns.position;
    std::int32_t* rows_crossed = rows_crossed_.data();
    std::int32_t* point_x = &point_x_[arc.first_part + 1];
    std::int32_t* point_y = &point_y_[arc.first_part + 1];
    const std::int32_t first_row = pixel_of(arc.from.y);
    const std::int32_t border = arc.border;
    const auto count = static_cast<std::int32_t>(columns.count);
    std::int32_t rows = 0;
    for (std::int32_t column = 0; column < count; ++column) {
        rows = std::max(rows, std::exchange(rows_crossed[column], 0));
        const std::int32_t low = (first_row + rows) * kSubpixel;
        point_x[rows + column] = border + column * kSubpixel;
        point_y[rows + column] = std::min(std::max(ys[column], low), low + kSubpixel);
    }
    rows_crossed[count] = 0;
}

// Computes the parts of all arcs, kLanes at once. Twice the area between the left border of a
// part's pixel and the part's chord is an integer that a float represents exactly. Twice the area
// between the chord and the arc is added to it. The middle of a part determines its pixel. In the
// lanes after the last part of an arc, the height is set to 0.
// NOLINTNEXTLINE(readability-function-size): a vectorized kernel keeps its loops in one function
void ArcSplitter::measure_parts() {
    at_simd_level([arcs = std::span(arcs_).first(size_),
                   last_row = rows_ - 1,
                   all_x = point_x_.data(),
                   all_y = point_y_.data(),
                   all_parts = parts_.data()] {
        constexpr float kHalf = 0.5F;  // makes the truncation round to the nearest
        for (const Arc& arc : arcs) {
            const std::int32_t sign = arc.sign;
            const float half_curvature = arc.half_curvature;
            const std::size_t end = arc.first_part + arc.parts;
            for (std::size_t from = arc.first_part; from < end; from += kLanes) {
                const std::int32_t* __restrict x = all_x + from;
                const std::int32_t* __restrict y = all_y + from;
                Part* __restrict parts = all_parts + from;
                const auto parts_left = static_cast<std::int32_t>(end - from);
                for (std::size_t k = 0; k < kLanes; ++k) {
                    const std::int32_t is_part = static_cast<std::int32_t>(k) < parts_left ? -1 : 0;
                    const std::int32_t height = (y[k + 1] - y[k]) & is_part;
                    const std::int32_t row = (y[k] + y[k + 1]) >> (kSubpixelBits + 1);
                    const std::int32_t twice_x = sign * (x[k] + x[k + 1]);
                    const std::int32_t column = twice_x >> (kSubpixelBits + 1);
                    const auto dx = static_cast<float>((x[k + 1] - x[k]) & is_part);
                    const auto dy = static_cast<float>(height);
                    const auto from_left = static_cast<float>(twice_x - 2 * kSubpixel * column);
                    const float squared = dx * dx + dy * dy;
                    const float bulge = twice_segment(squared, half_curvature * std::sqrt(squared));
                    const auto area = static_cast<std::int32_t>(dy * from_left + bulge + kHalf);
                    parts[k] = {row < last_row ? row : last_row,
                                column,
                                height * (2 * kSubpixel),
                                height > 0 ? area : 0};
                }
            }
        }
    });
}

}  // namespace foam::texgen
