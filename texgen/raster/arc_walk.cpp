#include "texgen/raster/arc_walk.h"

#include "texgen/raster/make_room.h"
#include "texgen/raster/monotone.h"
#include "texgen/raster/vector_clones.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace foam::texgen {

namespace {

constexpr std::size_t kLanes = 8;  // parts measured at once

// The area on the left of a chord is a whole number that floats hold; the arc bulges beyond it. The
// middle of a part tells its pixel, but where it has no height, and adds nothing to any row. What
// is beyond the parts fills the last vector.
FOAMTEX_VECTOR_CLONES void measure_parts(std::size_t count,
                                         std::int32_t last_row,
                                         float half_curvature,
                                         const std::int32_t* __restrict xs,
                                         const std::int32_t* __restrict ys,
                                         ArcWalk::Part* __restrict parts) {
    constexpr float kHalf = 0.5F;  // makes truncation the nearest
    for (std::size_t from = 0; from < count; from += kLanes) {
        const std::int32_t* x = xs + from;
        const std::int32_t* y = ys + from;
        for (std::size_t k = 0; k < kLanes; ++k) {
            const std::int32_t height = y[k + 1] - y[k];
            const std::int32_t row = (y[k] + y[k + 1]) >> (kSubpixelBits + 1);
            const std::int32_t column = (x[k] + x[k + 1]) >> (kSubpixelBits + 1);
            const auto dx = static_cast<float>(x[k + 1] - x[k]);
            const auto dy = static_cast<float>(height);
            const auto from_left = static_cast<float>(x[k] + x[k + 1] - 2 * kSubpixel * column);
            const float squared = dx * dx + dy * dy;
            const float bulge = twice_segment(squared, half_curvature * std::sqrt(squared));
            const auto area = static_cast<std::int32_t>(dy * from_left + bulge + kHalf);
            parts[from + k] = {row < last_row ? row : last_row,
                               column,
                               height * (2 * kSubpixel),
                               height > 0 ? area : 0};
        }
    }
}

}  // namespace

void ArcWalk::add(const CellArc& arc, SubpixelPoint translation) {
    const SubpixelPoint low = arc.low + translation;
    const SubpixelPoint high = arc.high + translation;
    const SubpixelPoint chord = high - low;
    const RisingArc rising(Vec2(chord.x, chord.y), arc.sine);
    const SubpixelPoint from =
        low.y < 0 ? SubpixelPoint{low.x + rounded(rising.x_at(-low.y)), 0} : low;
    const std::int32_t row = pixel_of(from.y);
    const std::int32_t last_row = pixel_of(std::min(high.y, rows_ * kSubpixel) - 1);
    const std::size_t k = size_++;
    Arc& own = arcs_[k];
    own.low = low;
    own.high = high;
    own.from = from;
    own.direction = chord.x < 0 ? -1 : 1;
    own.half_curvature = static_cast<float>(rising.half_curvature());
    row_crossings_[k] = {rising,
                         static_cast<double>((row + 1) * kSubpixel - low.y),
                         kSubpixel,
                         static_cast<std::size_t>(last_row - row) + 1,
                         k == 0 ? 0 : row_crossings_[k - 1].end()};
}

// Of all arcs one thing after the other.
void ArcWalk::split() {
    if (size_ == 0) {
        return;
    }
    make_room(xs_, row_crossings_[size_ - 1].end());
    find_xs(std::span(row_crossings_).first(size_), xs_.data());
    for (std::size_t k = 0; k < size_; ++k) {
        end_rows(k);
    }
    make_room(ys_, column_crossings_[size_ - 1].end() + kLanes);
    find_ys(std::span(column_crossings_).first(size_), ys_.data());
    const std::size_t points = arcs_[size_ - 1].first_part + arcs_[size_ - 1].parts + 1 + kLanes;
    make_room(point_x_, points);
    make_room(point_y_, points);
    make_room(parts_, points);
    for (std::size_t k = 0; k < size_; ++k) {
        join_crossings(k);
    }
    for (const Arc& arc : std::span(arcs_).first(size_)) {
        measure_parts(arc.parts,
                      rows_ - 1,
                      arc.half_curvature,
                      point_x_.data() + arc.first_part,
                      point_y_.data() + arc.first_part,
                      parts_.data() + arc.first_part);
    }
}

// Moves the crossings of borders above rows to where the arc lies, and finds which borders of
// columns it crosses.
void ArcWalk::end_rows(std::size_t k) {
    Arc& arc = arcs_[k];
    const ArcCrossings& rows = row_crossings_[k];
    const std::span<std::int32_t> xs = std::span(xs_).subspan(rows.place, rows.count);
    std::int32_t last = arc.from.x;
    if (arc.direction > 0) {  // rounding may take a step back
        for (std::int32_t& x : xs) {
            x = last = std::max(last, arc.low.x + x);
        }
    } else {
        for (std::int32_t& x : xs) {
            x = last = std::min(last, arc.low.x + x);
        }
    }
    if (arc.high.y <= rows_ * kSubpixel) {
        xs.back() = last = arc.high.x;
    }
    const std::int32_t first_column = pixel_of(arc.from.x);
    const std::int32_t last_column = pixel_of(last);
    arc.leftmost = std::min(first_column, last_column);
    arc.rightmost = std::max(first_column, last_column);
    arc.border = (arc.direction < 0 ? first_column : first_column + 1) * kSubpixel;
    const auto columns = static_cast<std::size_t>(arc.rightmost - arc.leftmost);
    column_crossings_[k] = {rows.arc,
                            static_cast<double>(arc.border - arc.low.x),
                            static_cast<double>(arc.direction * kSubpixel),
                            columns,
                            k == 0 ? 0 : column_crossings_[k - 1].end()};
    arc.parts = rows.count + columns;
    arc.first_part = k == 0 ? 0 : arcs_[k - 1].first_part + arcs_[k - 1].parts + kLanes;
}

// From row to row, each with the columns' borders that are crossed in it. Most rows have two of
// them at most: two are put down for all, and what is too many is written over.
void ArcWalk::join_crossings(std::size_t k) {
    const Arc arc = arcs_[k];  // a copy, which no point changes
    const std::int32_t* xs = &xs_[row_crossings_[k].place];
    const std::int32_t* ys = ys_.data() + column_crossings_[k].place;
    const std::size_t rows = row_crossings_[k].count;
    const std::int32_t end = std::min(arc.high.y, rows_ * kSubpixel);
    const std::int32_t step = arc.direction * kSubpixel;
    const std::int32_t first_column = pixel_of(arc.from.x);
    std::int32_t* x = &point_x_[arc.first_part];
    std::int32_t* y = &point_y_[arc.first_part];
    *x++ = arc.from.x;
    *y++ = arc.from.y;
    std::int32_t crossed = 0;
    std::int32_t low = arc.from.y;
    std::int32_t high = (pixel_of(low) + 1) * kSubpixel;
    for (std::size_t row = 0; row < rows; ++row) {
        high = std::min(high, end);
        const std::int32_t until = (pixel_of(xs[row]) - first_column) * arc.direction;
        const std::int32_t count = until - crossed;
        const std::int32_t border = arc.border + crossed * step;
        const auto put = [&](std::int32_t column) {
            x[column] = border + column * step;
            y[column] = std::min(std::max(arc.low.y + ys[column], low), high);
        };
        put(0);
        put(1);
        for (std::int32_t column = 2; column < count; ++column) {
            put(column);
        }
        x[count] = xs[row];
        y[count] = high;
        x += count + 1;
        y += count + 1;
        ys += count;
        crossed = until;
        low = high;
        high += kSubpixel;
    }
    std::fill_n(x, kLanes, x[-1]);
    std::fill_n(y, kLanes, y[-1]);
}

}  // namespace foam::texgen
