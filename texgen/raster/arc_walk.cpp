#include "texgen/raster/arc_walk.h"

#include "texgen/raster/monotone.h"
#include "texgen/raster/vector_clones.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace foam::texgen {

namespace {

// What a loop over the parts needs, so that it takes several of them at once.
struct PartColumns {
    std::size_t count;
    const std::int32_t* columns;
    const std::int32_t* x;
    const std::int32_t* y;
    std::int32_t* wholes;
    std::int32_t* on_left;
};

// The area on the left of a chord is a whole number that floats hold; the arc bulges beyond it.
FOAMTEX_VECTOR_CLONES void measure_parts(const PartColumns& parts, float half_curvature) {
    constexpr float kHalf = 0.5F;  // makes truncation the nearest
    const auto [count, columns, x, y, wholes, on_left] = parts;
    for (std::size_t k = 0; k < count; ++k) {
        const auto dx = static_cast<float>(x[k + 1] - x[k]);
        const auto dy = static_cast<float>(y[k + 1] - y[k]);
        const auto from_left = static_cast<float>(x[k] + x[k + 1] - 2 * kSubpixel * columns[k]);
        const float squared = dx * dx + dy * dy;
        const float bulge = twice_segment(squared, half_curvature * std::sqrt(squared));
        wholes[k] = (y[k + 1] - y[k]) * (2 * kSubpixel);
        on_left[k] = static_cast<std::int32_t>(dy * from_left + bulge + kHalf);
    }
}

// At least that many, for arrays that only grow.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t count) {
    if (values.size() < count) {
        values.resize(2 * count);
    }
}

}  // namespace

void ArcWalk::split(const CellArc& arc, SubpixelPoint translation) {
    const SubpixelPoint low = arc.low + translation;
    const SubpixelPoint high = arc.high + translation;
    runs_.clear();
    count_ = 0;
    if (high.y <= 0 || low.y >= top_) {
        return;
    }
    const SubpixelPoint chord = high - low;
    const RisingArc rising(Vec2(chord.x, chord.y), arc.sine);
    is_leftward_ = chord.x < 0;
    find_crossings(rising, low, high);
    join_crossings(high, pixel_of(from_.y));
    measure(rising.half_curvature());
}

// With the borders above each row, and with those of columns from where it enters the rows to where
// it leaves them.
void ArcWalk::find_crossings(const RisingArc& arc, SubpixelPoint low, SubpixelPoint high) {
    from_ = low.y < 0 ? SubpixelPoint{low.x + rounded(arc.x_at(-low.y)), 0} : low;
    const std::int32_t row = pixel_of(from_.y);
    const auto rows = static_cast<std::size_t>(pixel_of(std::min(high.y, top_) - 1) - row) + 1;
    make_room(xs_, rows);
    arc.find_x((row + 1) * kSubpixel - low.y, kSubpixel, std::span(xs_).first(rows));
    std::int32_t last = from_.x;
    for (std::size_t k = 0; k < rows; ++k) {  // rounding may take a step back
        const std::int32_t x = k + 1 == rows && high.y <= top_ ? high.x : low.x + xs_[k];
        last = is_leftward_ ? std::min(last, x) : std::max(last, x);
        xs_[k] = last;
    }
    const std::int32_t first = pixel_of(from_.x);
    const auto columns = static_cast<std::size_t>(std::abs(pixel_of(last) - first));
    make_room(ys_, columns);
    const std::int32_t border = (is_leftward_ ? first : first + 1) * kSubpixel;
    arc.find_y(
        border - low.x, is_leftward_ ? -kSubpixel : kSubpixel, std::span(ys_).first(columns));
    for (std::size_t k = 0; k < columns; ++k) {
        ys_[k] += low.y;
    }
    const std::size_t parts = rows + columns;
    make_room(columns_, parts);
    make_room(point_x_, parts + 1);
    make_room(point_y_, parts + 1);
    make_room(wholes_, parts);
    make_room(on_left_, parts);
}

void ArcWalk::append(std::int32_t column, SubpixelPoint end) {
    columns_[count_] = column;
    ++count_;
    point_x_[count_] = end.x;
    point_y_[count_] = end.y;
}

void ArcWalk::join_crossings(SubpixelPoint high, std::int32_t first_row) {
    const std::int32_t step = is_leftward_ ? -1 : 1;
    const std::int32_t far_side = is_leftward_ ? 0 : kSubpixel;
    const std::int32_t end = std::min(high.y, top_);
    std::int32_t column = pixel_of(from_.x);
    std::int32_t from_y = from_.y;
    const std::int32_t* y = ys_.data();
    const std::int32_t* x = xs_.data();
    point_x_[0] = from_.x;
    point_y_[0] = from_.y;
    for (std::int32_t row = first_row; from_y < end; ++row) {
        const std::size_t begin = count_;
        const SubpixelPoint to{*x++, std::min((row + 1) * kSubpixel, end)};
        for (const std::int32_t last = pixel_of(to.x); column != last; column += step) {
            append(column, {column * kSubpixel + far_side, std::clamp(*y++, from_y, to.y)});
        }
        append(column, to);
        runs_.push_back({row, begin, count_});
        from_y = to.y;
    }
}

void ArcWalk::measure(double half_curvature) {
    measure_parts({count_,
                   columns_.data(),
                   point_x_.data(),
                   point_y_.data(),
                   wholes_.data(),
                   on_left_.data()},
                  static_cast<float>(half_curvature));
}

}  // namespace foam::texgen
