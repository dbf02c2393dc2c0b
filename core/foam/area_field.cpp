// SPDX-License-Identifier: Apache-2.0

#include "core/foam/area_field.h"

#include "core/foam/polygon_samples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

// A field is constant in each cell of its grid. A random point is drawn by inversion (L. Devroye,
// Non-Uniform Random Variate Generation, 1986): a binary search in the cumulative sums of 1 / area
// finds the cell, in which the point is uniformly distributed. Integrals over polygons are sums
// over sample points (polygon_samples.h), so that a polygon need not be clipped to the cells of the
// grid. The areas of a field are relative, so the integral of 1 / area over a polygon is
// proportional to the number of bubbles in the polygon. The mean relative area of these bubbles is
// the area of the polygon divided by this integral. The mean over a polygon is therefore harmonic.

namespace foam {

AreaField::AreaField(int columns, int rows, std::vector<double> areas) {
    const auto cells = static_cast<std::size_t>(std::max(columns, 0)) *
                       static_cast<std::size_t>(std::max(rows, 0));
    if (cells == 0 || areas.size() != cells) {
        throw std::invalid_argument("an area field needs one area per cell of its grid");
    }
    std::vector<double> sums;
    sums.reserve(cells);
    double sum = 0.0;
    for (const double area : areas) {
        if (!(area > 0.0) || !std::isfinite(area)) {
            throw std::invalid_argument("the areas of an area field must be positive and finite");
        }
        sum += 1.0 / area;
        sums.push_back(sum);
    }
    grid_ = std::make_shared<const Grid>(Grid{columns, rows, std::move(areas), std::move(sums)});
}

AreaField AreaField::stretched_over(const Vec2& low, const Vec2& size) const {
    AreaField field = *this;
    field.low_ = low;
    field.size_ = size;
    return field;
}

double AreaField::at(const Vec2& point) const {
    const Vec2 relative = (point - low_).cwiseQuotient(size_);
    // If `position` is slightly negative, `inside` may be rounded to 1; std::min then selects the
    // last cell.
    const auto cell = [](double position, int cells) {
        const double inside = position - std::floor(position);
        return std::min(static_cast<int>(inside * cells), cells - 1);
    };
    const auto column = static_cast<std::size_t>(cell(relative.x(), grid_->columns));
    const auto row = static_cast<std::size_t>(cell(relative.y(), grid_->rows));
    return grid_->areas[row * static_cast<std::size_t>(grid_->columns) + column];
}

Vec2 AreaField::random_point(Random& random) const {
    const std::vector<double>& sums = grid_->sums;
    const double sum = random.uniform() * sums.back();
    const auto after = std::upper_bound(sums.begin(), sums.end() - 1, sum);
    const auto cell = static_cast<int>(after - sums.begin());
    const int column = cell % grid_->columns;
    const int row = cell / grid_->columns;
    const double x = (column + random.uniform()) / grid_->columns;
    const double y = (row + random.uniform()) / grid_->rows;
    return low_ + size_.cwiseProduct(Vec2(x, y));
}

double AreaField::cell_size() const {
    return std::min(size_.x() / grid_->columns, size_.y() / grid_->rows);
}

double AreaField::mean_over(std::span<const Vec2> polygon) const {
    double area = 0.0;
    double bubbles = 0.0;  // proportional to the number of bubbles
    visit_polygon_samples(polygon, cell_size(), [&](const Vec2& point, double weight) {
        area += weight;
        bubbles += weight / at(point);
    });
    return area / bubbles;
}

Vec2 AreaField::centroid_of(std::span<const Vec2> polygon) const {
    Vec2 moment = Vec2::Zero();
    double total = 0.0;
    visit_polygon_samples(polygon, cell_size(), [&](const Vec2& point, double weight) {
        const double area = at(point);
        const double mass = weight / (area * area);
        moment += mass * (point - polygon[0]);
        total += mass;
    });
    return polygon[0] + moment / total;
}

}  // namespace foam
