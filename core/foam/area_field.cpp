// SPDX-License-Identifier: Apache-2.0

#include "core/foam/area_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

// Integrals over a polygon are sums over samples. The polygon is divided into triangles that share
// its first corner. Each triangle is divided into n^2 equal triangles, so many that they are not
// longer than a cell of the grid, and the field is evaluated at the centroid of each.

namespace foam {

namespace {

// The largest n. A triangle is then at most 32 cells long, or the sampling becomes coarser than the
// grid, which has no effect on a field that is smooth in the size of a bubble.
constexpr int kMostDivisions = 32;

using Triangle = std::array<Vec2, 3>;

double signed_area(const Triangle& triangle) {
    return 0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
}

// Calls visit(centroid) for each of the n^2 equal triangles into which a triangle is divided.
template <class Visit>
void visit_parts(const Triangle& triangle, int n, const Visit& visit) {
    const Vec2 across = (triangle[1] - triangle[0]) / n;
    const Vec2 up = (triangle[2] - triangle[0]) / n;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i + j < n; ++i) {
            const Vec2 corner = triangle[0] + i * across + j * up;
            visit(Vec2(corner + (across + up) / 3.0));
            if (i + j + 1 < n) {
                visit(Vec2(corner + 2.0 * (across + up) / 3.0));
            }
        }
    }
}

double longest_side(const Triangle& triangle) {
    return std::max({(triangle[1] - triangle[0]).norm(),
                     (triangle[2] - triangle[1]).norm(),
                     (triangle[0] - triangle[2]).norm()});
}

}  // namespace

AreaField::AreaField(int columns, int rows, std::vector<double> areas)
    : columns_(columns), rows_(rows), areas_(std::move(areas)) {
    const auto cells = static_cast<std::size_t>(std::max(columns, 0)) *
                       static_cast<std::size_t>(std::max(rows, 0));
    if (cells == 0 || areas_.size() != cells) {
        throw std::invalid_argument("an area field needs one area per cell of its grid");
    }
    double sum = 0.0;
    for (const double area : areas_) {
        if (!(area > 0.0) || !std::isfinite(area)) {
            throw std::invalid_argument("the areas of an area field must be positive and finite");
        }
        sum += 1.0 / area;
        sums_.push_back(sum);
    }
}

AreaField AreaField::stretched_over(const Vec2& low, const Vec2& size) const {
    AreaField field = *this;
    field.low_ = low;
    field.size_ = size;
    return field;
}

double AreaField::at(const Vec2& point) const {
    const Vec2 at = (point - low_).cwiseQuotient(size_);
    // The remainder may be rounded to 1, which the minimum takes back to the last cell.
    const auto cell = [](double position, int cells) {
        const double inside = position - std::floor(position);
        return std::min(static_cast<int>(inside * cells), cells - 1);
    };
    const auto column = static_cast<std::size_t>(cell(at.x(), columns_));
    const auto row = static_cast<std::size_t>(cell(at.y(), rows_));
    return areas_[row * static_cast<std::size_t>(columns_) + column];
}

Vec2 AreaField::random_point(Random& random) const {
    const double sum = random.uniform() * sums_.back();
    const auto after = std::upper_bound(sums_.begin(), sums_.end() - 1, sum);
    const auto cell = static_cast<int>(after - sums_.begin());
    const double x = (cell % columns_ + random.uniform()) / columns_;
    const double y = (cell / columns_ + random.uniform()) / rows_;
    return low_ + size_.cwiseProduct(Vec2(x, y));
}

// Calls visit(point, weight) for the samples of a polygon; the sum of the weights is its area.
template <class Visit>
void AreaField::visit_samples(std::span<const Vec2> polygon, const Visit& visit) const {
    const double cell = std::min(size_.x() / columns_, size_.y() / rows_);
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
        const Triangle triangle{polygon[0], polygon[k], polygon[k + 1]};
        const double cells = std::ceil(longest_side(triangle) / cell);
        const int n = static_cast<int>(std::clamp(cells, 1.0, double{kMostDivisions}));
        const double weight = signed_area(triangle) / (static_cast<double>(n) * n);
        visit_parts(triangle, n, [&](const Vec2& point) { visit(point, weight); });
    }
}

double AreaField::mean_over(std::span<const Vec2> polygon) const {
    double area = 0.0;
    double bubbles = 0.0;
    visit_samples(polygon, [&](const Vec2& point, double weight) {
        area += weight;
        bubbles += weight / at(point);
    });
    return area / bubbles;
}

Vec2 AreaField::centroid_of(std::span<const Vec2> polygon) const {
    Vec2 moment = Vec2::Zero();
    double total = 0.0;
    visit_samples(polygon, [&](const Vec2& point, double weight) {
        const double area = at(point);
        const double mass = weight / (area * area);
        moment += mass * (point - polygon[0]);
        total += mass;
    });
    return polygon[0] + moment / total;
}

}  // namespace foam
