// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/arc_distance.h"

#include "core/parallel/parallel_for.h"
#include "texgen/maps/grid_positions.h"
#include "texgen/raster/distance/region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace foam::texgen {

namespace {

constexpr int kBandRows = 32;  // rows that one thread computes at a time

// Returns the distance from a point to the circle of an arc, and the direction from the nearest
// point of the circle to the given point. Let p be the point relative to the tail of the arc, c the
// chord, and a the half angle. With the scalar product p.c and the cross product c x p, let
//     q = |p|² sin a - p.c sin a - (c x p) cos a.
// The distance is
//     |q| / (|c| / 2 + sqrt(|c|² / 4 + q sin a)).
// This formula also holds for a straight line, where a = 0. The gradient of |q| points away from
// the nearest point of the circle.
NearestOnArc nearest_on_circle(const PixelArc& arc, const Vec2& point) {
    const double q = arc.sine * point.dot(point - arc.chord) - arc.cosine * cross(arc.chord, point);
    const double half_chord = 0.5 * arc.chord.norm();
    const double root = std::sqrt(std::max(half_chord * half_chord + q * arc.sine, 0.0));
    const Vec2 gradient =
        arc.sine * (2.0 * point - arc.chord) - arc.cosine * turned_left(arc.chord);
    return {std::abs(q) / (half_chord + root), q < 0.0 ? Vec2(-gradient) : gradient};
}

// Returns a radius such that the circle around the middle of the chord with this radius contains
// the whole arc. The point of the arc that is farthest from the middle of the chord is an end or
// the middle of the arc.
double radius_around_chord(const PixelArc& arc) {
    const Vec2 middle = halves(arc)[0].chord;
    return std::max(0.5 * arc.chord.norm(), (middle - 0.5 * arc.chord).norm());
}

// An arc, or a periodic copy of it, with the square of pixels that are near it.
struct ArcCopy {
    const PixelArc* arc;
    Vec2 tail;      // in pixels of the image
    Vec2 center;    // center of the square, in pixels of the image
    double extent;  // half the side of the square
};

// Returns all copies whose squares overlap the image, and some copies near the image. The square of
// a copy contains all points that are at most `reach` pixels from this copy.
std::vector<ArcCopy> copies_in_image(std::span<const PlacedArc> arcs,
                                     const RasterGrid& grid,
                                     const Domain& domain,
                                     double reach) {
    std::vector<ArcCopy> copies;
    for (const PlacedArc& placed : arcs) {
        const double radius = radius_around_chord(placed.arc);
        for_each_copy(grid, domain, placed.tail, reach + 2.0 * radius, [&](const Vec2& tail) {
            const Vec2 start = tail / kSubpixel;
            copies.push_back({&placed.arc, start, start + 0.5 * placed.arc.chord, radius + reach});
        });
    }
    return copies;
}

// A half-open range of rows or columns of pixels.
struct PixelRange {
    int begin;
    int end;
};

// Returns the part of `range` that is near a position. It contains all pixels of the range that are
// at most `extent` from the position, and possibly a few pixels that are farther away.
PixelRange range_near(double position, double extent, PixelRange range) {
    const double first = std::floor(position - extent);
    const double last = std::ceil(position + extent);
    return {static_cast<int>(std::max(first, static_cast<double>(range.begin))),
            static_cast<int>(std::min(last + 1.0, static_cast<double>(range.end)))};
}

// If the distance of `nearest` is smaller than the distance stored at a pixel, replaces the stored
// distance and, if gradients are needed, the stored gradient.
void lower_to(const NearestOnArc& nearest, int x, int y, ArcDistances& distances) {
    float& distance = distances.distance.pixel(x, y)[0];
    if (static_cast<float>(nearest.distance) >= distance) {
        return;
    }
    distance = static_cast<float>(nearest.distance);
    if (!distances.gradient.samples().empty()) {
        const Vec2 gradient = nearest.direction.stableNormalized();
        const auto pixel = distances.gradient.pixel(x, y);
        pixel[0] = static_cast<float>(gradient.x());
        pixel[1] = static_cast<float>(gradient.y());
    }
}

// Adds one copy of an arc to the distances at the pixels of the given rows. Where the copy is
// nearer than the arcs added before, the distance from the copy replaces the stored distance.
void add_arc(const ArcCopy& copy, PixelRange rows, ArcDistances& distances) {
    const PixelRange columns =
        range_near(copy.center.x(), copy.extent, {0, distances.distance.width()});
    const PixelRange own_rows = range_near(copy.center.y(), copy.extent, rows);
    for (int y = own_rows.begin; y < own_rows.end; ++y) {
        for (int x = columns.begin; x < columns.end; ++x) {
            const Vec2 point = Vec2(x + 0.5, y + 0.5) - copy.tail;
            lower_to(nearest_on_arc(*copy.arc, point), x, y, distances);
        }
    }
}

// Makes the distances above `reach` infinite, and their gradients zero.
void limit(ArcDistances& distances, double reach) {
    const bool has_gradient = !distances.gradient.samples().empty();
    for (std::size_t k = 0; k < distances.distance.samples().size(); ++k) {
        float& distance = distances.distance.samples()[k];
        if (static_cast<double>(distance) > reach) {
            distance = std::numeric_limits<float>::infinity();
            if (has_gradient) {
                distances.gradient.samples()[2 * k] = 0.0F;
                distances.gradient.samples()[2 * k + 1] = 0.0F;
            }
        }
    }
}

}  // namespace

NearestOnArc nearest_on_arc(const PixelArc& arc, const Vec2& point) {
    // The nearest point is an inner point of the arc if the given point is between the normals at
    // both ends. This is a test of two half-planes. The test fails for arcs that turn by more than
    // 180 degrees. Therefore, arcs that turn by more than 120 degrees (DistanceArc::kMinCosine) are
    // halved.
    if (arc.cosine < DistanceArc::kMinCosine) {
        const auto [first, second] = halves(arc);
        const NearestOnArc on_first = nearest_on_arc(first, point);
        const NearestOnArc on_second = nearest_on_arc(second, point - first.chord);
        return on_first.distance <= on_second.distance ? on_first : on_second;
    }
    const Vec2 from_head = point - arc.chord;
    if (arc.chord.isZero(0.0)) {
        return {point.norm(), point};
    }
    if (tail_tangent(arc).dot(point) >= 0.0 && head_tangent(arc).dot(from_head) <= 0.0) {
        return nearest_on_circle(arc, point);
    }
    const Vec2 nearer = point.squaredNorm() <= from_head.squaredNorm() ? point : from_head;
    return {nearer.norm(), nearer};
}

ArcDistances distances_to_arcs(std::span<const PlacedArc> arcs,
                               const RasterGrid& grid,
                               const Domain& domain,
                               const ArcDistanceNeeds& needs,
                               int threads) {
    ArcDistances distances{{grid.width, grid.height, 1}, {}};
    if (needs.gradient) {
        distances.gradient = {grid.width, grid.height, 2};
    }
    std::fill(distances.distance.samples().begin(),
              distances.distance.samples().end(),
              std::numeric_limits<float>::infinity());
    const std::vector<ArcCopy> copies = copies_in_image(arcs, grid, domain, needs.reach);
    const auto rows = static_cast<std::size_t>(grid.height);
    parallel_for(rows, kBandRows, threads, [&](std::size_t first, std::size_t last) {
        for (const ArcCopy& copy : copies) {
            add_arc(copy, {static_cast<int>(first), static_cast<int>(last)}, distances);
        }
    });
    limit(distances, needs.reach);
    return distances;
}

ArcDistanceNeeds stroke_needs(double width) {
    return {.reach = 0.5 * std::max(width, 1.0) + 1.0};
}

Image<float> stroke_coverage(Image<float> distance, double width) {
    const double half_width = 0.5 * std::max(width, 1.0);
    const double strength = std::min(width, 1.0);
    for (float& sample : distance.samples()) {
        const double inside = half_width - static_cast<double>(sample);
        sample = static_cast<float>(strength * std::clamp(0.5 + inside, 0.0, 1.0));
    }
    return distance;
}

}  // namespace foam::texgen
