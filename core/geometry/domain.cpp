// SPDX-License-Identifier: Apache-2.0

#include "core/geometry/domain.h"

#include <cmath>
#include <limits>

namespace foam {

namespace {

// Returns k = floor(x / period), the number of whole periods in x. Returns 0 in three cases:
// - x is negative and so close to 0 that x + period rounds to the period;
// - k does not fit into 32 bits;
// - x is NaN.
//
// In all other cases, k is corrected for rounding errors: the computed value of x - k * period is
// in [0, period).
std::int32_t periods_below(double x, double period) {
    double k = std::floor(x / period);
    if (x - k * period < 0.0) {
        k -= 1.0;
    } else if (x - k * period >= period) {
        k += 1.0;
    }
    constexpr double kMax = std::numeric_limits<std::int32_t>::max();
    return std::abs(k) <= kMax ? static_cast<std::int32_t>(k) : 0;
}

}  // namespace

LatticeOffset Domain::cell_of(const Vec2& point) const {
    if (is_plane()) {
        return {};
    }
    const std::int32_t j = periods_below(point.y(), height);
    return {periods_below(point.x() - j * shear, width), j};
}

std::vector<LatticeOffset> Domain::offsets_near(const Vec2& point, double reach) const {
    if (is_plane()) {
        return {LatticeOffset{}};
    }
    std::vector<LatticeOffset> offsets;
    const std::int32_t top = periods_below(point.y() + reach, height);
    for (std::int32_t j = periods_below(point.y() - reach, height); j <= top; ++j) {
        const double x = point.x() - j * shear;
        const std::int32_t last = periods_below(x + reach, width);
        for (std::int32_t i = periods_below(x - reach, width); i <= last; ++i) {
            offsets.push_back({i, j});
        }
    }
    return offsets;
}

Vec2 Domain::nearest_copy(const Vec2& vector) const {
    if (is_plane()) {
        return vector;
    }
    const double middle = std::round(vector.y() / height);
    const auto nearest_in_row = [&](double j) {
        const double x = vector.x() - j * shear;
        return Vec2(x - width * std::round(x / width), vector.y() - j * height);
    };
    Vec2 nearest = nearest_in_row(middle);
    // The copies of the vector form rows of equal y. The middle row is the row nearest to y = 0.
    // Its shortest copy has |x| <= width / 2 and |y| <= height / 2, and so a length of at most
    // (width + height) / 2. A shorter copy can only be in a row with |y| < (width + height) / 2.
    // Such a row is less than width / (2 height) + 1 rows away from the middle row. Without shear
    // the middle row contains the shortest copy.
    const double rows = shear == 0.0 ? 0.0 : std::ceil(0.5 * width / height) + 1.0;
    for (double j = middle - rows; j <= middle + rows; j += 1.0) {
        const Vec2 copy = nearest_in_row(j);
        nearest = copy.squaredNorm() < nearest.squaredNorm() ? copy : nearest;
    }
    return nearest;
}

double Domain::shear_since(const Domain& earlier) const {
    return is_plane() ? 0.0 : std::remainder(shear - earlier.shear, width);
}

}  // namespace foam
