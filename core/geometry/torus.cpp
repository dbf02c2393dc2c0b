#include "core/geometry/torus.h"

#include <cmath>

namespace foam {

namespace {

// floor(x / period), corrected so that x minus that many periods, as computed, lies in [0, period).
std::int32_t periods_below(double x, double period) {
    double k = std::floor(x / period);
    if (x - k * period < 0.0) {
        k -= 1.0;
    } else if (x - k * period >= period) {
        k += 1.0;
    }
    return static_cast<std::int32_t>(k);
}

}  // namespace

LatticeOffset Torus::cell_of(const Vec2& point) const {
    if (is_plane()) {
        return {};
    }
    return {periods_below(point.x(), width), periods_below(point.y(), height)};
}

Vec2 Torus::nearest_copy(const Vec2& vector) const {
    return {vector.x() - width * std::round(vector.x() / width),
            vector.y() - height * std::round(vector.y() / height)};
}

}  // namespace foam
