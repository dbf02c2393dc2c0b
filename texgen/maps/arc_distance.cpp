// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include "texgen/maps/grid_positions.h"
#include "texgen/raster/distance/arc_lanes.h"
#include "texgen/raster/distance/boundary.h"

#include <algorithm>
#include <cmath>

namespace foam::texgen {

namespace {

// Returns the distance from a point to the circle of an arc. With the point p relative to the tail,
// the chord c, the half angle a and q = |p|² sin a - p.c sin a - (c x p) cos a, the distance is
// |q| / (|c| / 2 + sqrt(|c|² / 4 + q sin a)). This holds for a straight line, too, where a = 0.
double distance_to_circle(const PixelArc& arc, const Vec2& point) {
    const double q = arc.sine * point.dot(point - arc.chord) - arc.cosine * cross(arc.chord, point);
    const double half_chord = 0.5 * arc.chord.norm();
    const double root = std::sqrt(std::max(half_chord * half_chord + q * arc.sine, 0.0));
    return std::abs(q) / (half_chord + root);
}

// Returns the radius of a circle around the middle of the chord that contains the whole arc. The
// point of the arc that is farthest from the middle of the chord is an end or the middle of the
// arc.
double radius_around_chord(const PixelArc& arc) {
    const Vec2 middle = halves(arc)[0].chord;
    return std::max(0.5 * arc.chord.norm(), (middle - 0.5 * arc.chord).norm());
}

// Calls visit(x, y, point) for all pixels of the grid whose centers are within `reach` of an arc,
// and for other pixels nearby. `point` is the center of the pixel relative to the tail, in pixels.
template <class Visit>
void for_each_pixel_near(const PixelArc& arc,
                         SubpixelPoint tail,
                         const RasterGrid& grid,
                         double reach,
                         const Visit& visit) {
    const double radius = radius_around_chord(arc);
    const Vec2 start = Vec2(tail.x, tail.y) / kSubpixel;
    const Vec2 center = start + 0.5 * arc.chord;
    const auto first = [&](double middle) {
        return std::max(static_cast<int>(std::floor(middle - radius - reach)), 0);
    };
    const auto last = [&](double middle, int size) {
        return std::min(static_cast<int>(std::ceil(middle + radius + reach)), size - 1);
    };
    for (int y = first(center.y()); y <= last(center.y(), grid.height); ++y) {
        for (int x = first(center.x()); x <= last(center.x(), grid.width); ++x) {
            visit(x, y, Vec2(x + 0.5, y + 0.5) - start);
        }
    }
}

}  // namespace

double distance_to_arc(const PixelArc& arc, const Vec2& point) {
    // A point between the normals at both ends is nearest to an inner point of the arc. Two
    // half-planes decide this, but only if the arc does not turn far (ArcLanes::kMinCosine).
    if (arc.cosine < ArcLanes::kMinCosine) {
        const auto [first, second] = halves(arc);
        return std::min(distance_to_arc(first, point),
                        distance_to_arc(second, point - first.chord));
    }
    const Vec2 from_head = point - arc.chord;
    if (arc.chord.isZero(0.0)) {
        return point.norm();
    }
    if (tail_tangent(arc).dot(point) >= 0.0 && head_tangent(arc).dot(from_head) <= 0.0) {
        return distance_to_circle(arc, point);
    }
    return std::sqrt(std::min(point.squaredNorm(), from_head.squaredNorm()));
}

Image<float> distance_to_arcs(std::span<const PlacedArc> arcs,
                              const RasterGrid& grid,
                              const Domain& domain,
                              double reach) {
    Image<float> image(grid.width, grid.height, 1);
    std::fill(image.samples().begin(), image.samples().end(), static_cast<float>(reach));
    for (const PlacedArc& one : arcs) {
        const double extent = reach + 2.0 * radius_around_chord(one.arc);
        for_each_copy(grid, domain, one.tail, extent, [&](SubpixelPoint tail) {
            for_each_pixel_near(one.arc, tail, grid, reach, [&](int x, int y, const Vec2& point) {
                float& distance = image.pixel(x, y)[0];
                distance = std::min(distance, static_cast<float>(distance_to_arc(one.arc, point)));
            });
        });
    }
    return image;
}

Image<float> stroke_coverage(std::span<const PlacedArc> arcs,
                             const RasterGrid& grid,
                             const Domain& domain,
                             double width) {
    const double half_width = 0.5 * std::max(width, 1.0);
    const double strength = std::min(width, 1.0);
    Image<float> image = distance_to_arcs(arcs, grid, domain, half_width + 1.0);
    for (float& sample : image.samples()) {
        const double inside = half_width - static_cast<double>(sample);
        sample = static_cast<float>(strength * std::clamp(0.5 + inside, 0.0, 1.0));
    }
    return image;
}

}  // namespace foam::texgen
