// SPDX-License-Identifier: Apache-2.0

#include "core/foam/outline.h"

#include "core/geometry/elementary.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

namespace foam {

namespace {

namespace bg = boost::geometry;

using BoostPoint = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<BoostPoint, false, true>;  // counter-clockwise, closed

constexpr int kCornersOfDisc = 360;
// Smallest area of an outline in WKT, as a fraction of the square of its size (size_of). Even for a
// row of a million bubbles, this fraction is larger: a millionth.
constexpr double kMinAreaFraction = 1e-9;

Polygon::ring_type ring_of(const std::vector<Vec2>& corners) {
    Polygon::ring_type ring;
    for (const Vec2& corner : corners) {
        ring.emplace_back(corner.x(), corner.y());
    }
    return ring;
}

Polygon polygon_of(const Outline& outline) {
    Polygon polygon;
    polygon.outer() = ring_of(outline.outer);
    for (const std::vector<Vec2>& hole : outline.holes) {
        polygon.inners().push_back(ring_of(hole));
    }
    bg::correct(polygon);
    return polygon;
}

// Returns the corners of a closed ring without the last one, which repeats the first.
std::vector<Vec2> corners_of(const Polygon::ring_type& ring) {
    std::vector<Vec2> corners;
    for (std::size_t k = 0; k + 1 < ring.size(); ++k) {
        corners.emplace_back(ring[k].x(), ring[k].y());
    }
    return corners;
}

Outline outline_of(const Polygon& polygon) {
    Outline outline{corners_of(polygon.outer()), {}};
    for (const Polygon::ring_type& hole : polygon.inners()) {
        outline.holes.push_back(corners_of(hole));
    }
    return outline;
}

std::string reason_of(bg::validity_failure_type failure) {
    switch (failure) {
        case bg::failure_few_points:
            return "a ring has fewer than three corners";
        case bg::failure_wrong_topological_dimension:
        case bg::failure_spikes:
            return "the polygon has no area, or a part of it has none";
        case bg::failure_self_intersections:
        case bg::failure_wrong_orientation:
            // bg::correct has oriented the rings. This failure remains only if the polygon crosses
            // itself.
            return "the polygon crosses or touches itself";
        case bg::failure_interior_rings_outside:
            return "a hole is outside of the polygon";
        case bg::failure_nested_interior_rings:
            return "a hole is inside of another hole";
        case bg::failure_disconnected_interior:
            return "holes divide the polygon into several parts";
        case bg::failure_invalid_coordinate:
            return "a coordinate is not a finite number";
        default:
            return bg::validity_failure_type_message(failure);
    }
}

// Returns the longer side of the bounding box.
double size_of(const Polygon& polygon) {
    const auto box = bg::return_envelope<bg::model::box<BoostPoint>>(polygon);
    return std::max(box.max_corner().x() - box.min_corner().x(),
                    box.max_corner().y() - box.min_corner().y());
}

void check_validity(const Polygon& polygon) {
    bg::validity_failure_type failure = bg::no_failure;
    if (!bg::is_valid(polygon, failure)) {
        throw std::invalid_argument(reason_of(failure));
    }
    const double area = bg::area(polygon);
    if (!std::isfinite(area)) {
        throw std::invalid_argument("the coordinates are too large");
    }
    const double size = size_of(polygon);
    if (area / size < kMinAreaFraction * size) {  // not divided by the square, which may overflow
        throw std::invalid_argument(
            "the polygon is too narrow: its area is less than a billionth of the square of its "
            "length");
    }
}

bool is_line_space(char c) {
    return c == '\n' || c == '\r' || c == '\t';
}

// Throws std::invalid_argument unless the text of a point has two numbers.
void check_point(const std::string& text) {
    std::istringstream words(text);
    const auto numbers = std::distance(std::istream_iterator<std::string>(words), {});
    if (numbers != 2) {
        throw std::invalid_argument(
            "each point must have two numbers, such as '6 4', but a point has " +
            std::to_string(numbers));
    }
}

// Throws std::invalid_argument unless each point of a WKT polygon has two numbers. Boost.Geometry
// replaces missing numbers by 0 and ignores further ones. Precondition: Boost.Geometry has read the
// text as a polygon.
void check_points(const std::string& text) {
    // The text between the brackets or commas at `begin` and `end` may be a point.
    std::size_t begin = text.find('(');
    while (begin != std::string::npos) {
        const std::size_t end = text.find_first_of("(),", begin + 1);
        if (end != std::string::npos && text[end] != '(' && text[begin] != ')') {
            check_point(text.substr(begin + 1, end - begin - 1));
        }
        begin = end;
    }
}

Box box_around(const Vec2& a, const Vec2& b) {
    return {a.cwiseMin(b), a.cwiseMax(b)};
}

void include(const Vec2& point, Box& box) {
    box = {box.low.cwiseMin(point), box.high.cwiseMax(point)};
}

bool touch(const Box& a, const Box& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
}

bool is_apart(const std::vector<Vec2>& ring, const Box& bounds) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
        if (touch(bounds, box_around(ring[k], ring[(k + 1) % ring.size()]))) {
            return false;
        }
    }
    return true;
}

// Returns true if no side of the outline has a bounding box that touches the bounding box of the
// polygon. The polygon is then entirely inside or entirely outside of the outline. This is so for
// most cells of a Voronoi diagram, and this test is much faster than an intersection.
bool is_apart_from_rings(const Outline& outline, const std::vector<Vec2>& polygon) {
    Box bounds{polygon.front(), polygon.front()};
    for (const Vec2& point : polygon) {
        include(point, bounds);
    }
    return is_apart(outline.outer, bounds) &&
           std::ranges::all_of(outline.holes, [&](const std::vector<Vec2>& hole) {
               return is_apart(hole, bounds);
           });
}

}  // namespace

Outline outline_from_wkt(std::string text) {
    std::ranges::replace_if(text, is_line_space, ' ');  // Boost.Geometry knows only spaces
    Polygon polygon;
    try {
        bg::read_wkt(text, polygon);
    } catch (const bg::read_wkt_exception&) {
        throw std::invalid_argument(
            std::ranges::count(text, '(') > std::ranges::count(text, ')')
                ? "a bracket of the WKT polygon is not closed"
                : "this is not written as a WKT polygon; check its brackets, commas and numbers");
    }
    check_points(text);
    bg::correct(polygon);
    check_validity(polygon);
    return outline_of(polygon);
}

Outline disc_outline() {
    Outline outline;
    for (int k = 0; k < kCornersOfDisc; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kCornersOfDisc;
        outline.outer.push_back(unit_vector(angle));
    }
    return outline;
}

Outline rectangle_outline(double aspect) {
    return {{{0.0, 0.0}, {aspect, 0.0}, {aspect, 1.0}, {0.0, 1.0}}, {}};
}

double outline_area(const Outline& outline) {
    return bg::area(polygon_of(outline));
}

Box bounding_box(std::span<const Outline> parts) {
    Box box{parts.front().outer.front(), parts.front().outer.front()};
    for (const Outline& part : parts) {
        for (const Vec2& corner : part.outer) {
            include(corner, box);
        }
    }
    return box;
}

double bounding_aspect(std::span<const Outline> parts) {
    const Vec2 size = bounding_box(parts).size();
    return size.x() / size.y();
}

Vec2 outline_centroid(const Outline& outline) {
    BoostPoint center(0.0, 0.0);
    bg::centroid(polygon_of(outline), center);
    return {center.x(), center.y()};
}

bool is_inside(const Outline& outline, const Vec2& point) {
    return bg::within(BoostPoint(point.x(), point.y()), polygon_of(outline));
}

std::vector<std::vector<Vec2>> clipped(const Outline& outline, const std::vector<Vec2>& polygon) {
    if (is_apart_from_rings(outline, polygon)) {
        return std::vector<std::vector<Vec2>>(is_inside(outline, polygon.front()) ? 1 : 0, polygon);
    }
    std::vector<Polygon> parts;
    bg::intersection(polygon_of(outline), polygon_of({polygon, {}}), parts);
    std::vector<std::vector<Vec2>> rings;
    rings.reserve(parts.size());
    for (const Polygon& part : parts) {
        rings.push_back(corners_of(part.outer()));
    }
    return rings;
}

}  // namespace foam
