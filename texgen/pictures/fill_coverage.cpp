// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/fill_coverage.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>

// Each row of pixels is crossed by kRowsOfPixel horizontal lines, which are called rows of samples.
// Along each row of samples, the winding numbers of each shape give the spans that the shape
// covers. The union of the spans of all shapes is added to the pixels of the row.

namespace foam::texgen {

namespace {

constexpr int kRowsOfPixel = 8;

// A side of a ring that crosses at least one row of samples.
struct Side {
    Vec2 low;
    Vec2 high;
    int winding;  // 1 if the ring goes up along the side, otherwise -1
    std::size_t shape;
    int first_row;  // the first row of samples that the side crosses
    int end_row;    // one past the last such row

    double x_at(double y) const {
        return low.x() + (high.x() - low.x()) * ((y - low.y()) / (high.y() - low.y()));
    }
};

// Returns the y coordinate of a row of samples.
double height_of(int row) {
    return (row + 0.5) / kRowsOfPixel;
}

// Returns the first row of samples at or above a height.
int first_row_above(double y, int rows) {
    return static_cast<int>(
        std::clamp(std::ceil(y * kRowsOfPixel - 0.5), 0.0, static_cast<double>(rows)));
}

// Appends the sides of a ring that cross a row of samples.
void add_sides(const std::vector<Vec2>& ring,
               std::size_t shape,
               int rows,
               std::vector<Side>& sides) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2& from = ring[k];
        const Vec2& to = ring[(k + 1) % ring.size()];
        const bool is_up = from.y() < to.y();
        const Vec2& low = is_up ? from : to;
        const Vec2& high = is_up ? to : from;
        const int first = first_row_above(low.y(), rows);
        const int end = first_row_above(high.y(), rows);
        if (first < end) {
            sides.push_back({low, high, is_up ? 1 : -1, shape, first, end});
        }
    }
}

std::vector<Side> sides_of(std::span<const FilledShape> shapes, int rows) {
    std::vector<Side> sides;
    for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
        for (const std::vector<Vec2>& ring : shapes[shape].rings) {
            add_sides(ring, shape, rows, sides);
        }
    }
    std::ranges::stable_sort(sides, {}, &Side::first_row);
    return sides;
}

// A point where a side crosses a row of samples.
struct Crossing {
    std::size_t shape;
    double x;
    int winding;
};

using Span = std::pair<double, double>;

// Appends the spans that the shapes cover, shape by shape.
void add_spans(std::vector<Crossing>& crossings,
               std::span<const FilledShape> shapes,
               std::vector<Span>& spans) {
    std::ranges::sort(crossings, [](const Crossing& a, const Crossing& b) {
        return std::tie(a.shape, a.x, a.winding) < std::tie(b.shape, b.x, b.winding);
    });
    int winding = 0;  // returns to 0 at the end of each shape, because rings are closed
    for (std::size_t k = 0; k + 1 < crossings.size(); ++k) {
        winding += crossings[k].winding;
        const bool is_covered =
            shapes[crossings[k].shape].is_even_odd ? winding % 2 != 0 : winding != 0;
        if (is_covered) {
            spans.emplace_back(crossings[k].x, crossings[k + 1].x);
        }
    }
}

// Adds the length of a span within each pixel, times the height of a row of samples.
void add_span(Image<float>& grid, int y, const Span& span) {
    const double left = std::max(0.0, span.first);
    const double right = std::min(static_cast<double>(grid.width()), span.second);
    for (int x = static_cast<int>(left); x < right; ++x) {
        const double length =
            std::min(right, static_cast<double>(x) + 1.0) - std::max(left, static_cast<double>(x));
        grid.pixel(x, y)[0] += static_cast<float>(length / kRowsOfPixel);
    }
}

// Adds the union of the spans.
void add_union(Image<float>& grid, int y, std::vector<Span>& spans) {
    std::ranges::sort(spans);
    for (std::size_t k = 0; k < spans.size();) {
        Span whole = spans[k];
        for (++k; k < spans.size() && spans[k].first <= whole.second; ++k) {
            whole.second = std::max(whole.second, spans[k].second);
        }
        add_span(grid, y, whole);
    }
}

}  // namespace

Image<float> fill_coverage(std::span<const FilledShape> shapes, int width, int height) {
    Image<float> grid(width, height, 1);
    const int rows = height * kRowsOfPixel;
    const std::vector<Side> sides = sides_of(shapes, rows);
    std::vector<Side> active;
    std::vector<Crossing> crossings;
    std::vector<Span> spans;
    auto next = sides.begin();
    for (int row = 0; row < rows; ++row) {
        std::erase_if(active, [&](const Side& side) { return side.end_row <= row; });
        for (; next != sides.end() && next->first_row == row; ++next) {
            active.push_back(*next);
        }
        crossings.clear();
        for (const Side& side : active) {
            crossings.push_back({side.shape, side.x_at(height_of(row)), side.winding});
        }
        spans.clear();
        add_spans(crossings, shapes, spans);
        add_union(grid, row / kRowsOfPixel, spans);
    }
    return grid;
}

}  // namespace foam::texgen
