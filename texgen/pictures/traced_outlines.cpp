// SPDX-License-Identifier: Apache-2.0

#include "texgen/pictures/traced_outlines.h"

#include "texgen/pictures/contours.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

namespace bg = boost::geometry;

using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false, true>;  // counter-clockwise, closed
using Ring = Polygon::ring_type;

// Parts and holes below this fraction of the area of the region are dropped. The dot of an i is
// about 1/100 of a word of ten letters.
constexpr double kSpeck = 1e-3;
// The simplification moves a ring by at most this distance, in units of the spacing of the grid.
constexpr double kTolerance = 0.25;

Ring ring_of(const std::vector<Vec2>& corners) {
    Ring ring;
    ring.reserve(corners.size() + 1);
    for (const Vec2& corner : corners) {
        ring.emplace_back(corner.x(), corner.y());
    }
    ring.push_back(ring.front());
    return ring;
}

std::vector<Vec2> corners_of(const Ring& ring) {
    std::vector<Vec2> corners;
    corners.reserve(ring.size());
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
        corners.emplace_back(ring[k].x(), ring[k].y());
    }
    return corners;
}

// A ring with its area, which is negative for a hole.
struct SignedRing {
    Ring ring;
    double area;
};

// Returns the rings of a region, except specks, by decreasing magnitude of their areas.
std::vector<SignedRing> large_rings(const std::vector<std::vector<Vec2>>& all) {
    std::vector<SignedRing> rings;
    double total = 0.0;
    for (const std::vector<Vec2>& corners : all) {
        Ring ring = ring_of(corners);
        const double area = bg::area(ring);
        total += area;
        rings.push_back({std::move(ring), area});
    }
    std::erase_if(rings,
                  [&](const SignedRing& one) { return std::abs(one.area) < kSpeck * total; });
    std::ranges::stable_sort(rings, [](const SignedRing& a, const SignedRing& b) {
        return std::abs(a.area) > std::abs(b.area);
    });
    return rings;
}

// Returns the parts with their holes. Each hole belongs to the smallest part around it; a hole
// outside of all parts is dropped.
std::vector<Polygon> polygons_of(const std::vector<SignedRing>& rings) {
    std::vector<Polygon> polygons;
    for (const SignedRing& one : rings) {
        if (one.area > 0.0) {
            polygons.emplace_back().outer() = one.ring;
        }
    }
    for (const SignedRing& one : rings) {
        const auto enclosing =
            std::find_if(polygons.rbegin(), polygons.rend(), [&](const Polygon& polygon) {
                return one.area < 0.0 && bg::within(one.ring.front(), polygon.outer());
            });
        if (enclosing != polygons.rend()) {
            enclosing->inners().push_back(one.ring);
        }
    }
    return polygons;
}

// Returns the simplified polygon. If it is not valid, for example because it crosses itself, tries
// smaller tolerances, and finally returns the polygon itself.
Polygon simplified(const Polygon& polygon) {
    for (double tolerance = kTolerance; tolerance > kTolerance / 100.0; tolerance /= 4.0) {
        Polygon simple;
        bg::simplify(polygon, simple, tolerance);
        if (bg::is_valid(simple)) {
            return simple;
        }
    }
    return polygon;
}

foam::Outline outline_of(const Polygon& polygon) {
    foam::Outline outline{corners_of(polygon.outer()), {}};
    for (const Ring& hole : polygon.inners()) {
        outline.holes.push_back(corners_of(hole));
    }
    return outline;
}

}  // namespace

std::vector<foam::Outline> traced_outlines(const Image<float>& grid, double level) {
    std::vector<foam::Outline> outlines;
    for (const Polygon& polygon : polygons_of(large_rings(contours(grid, level)))) {
        outlines.push_back(outline_of(simplified(polygon)));
    }
    return outlines;
}

}  // namespace foam::texgen
