// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/geometry/vec2.h"

#include <span>
#include <string>
#include <vector>

namespace foam {

/// The region in which a patch is seeded: a polygon with holes, in any units. The outer ring is
/// counter-clockwise, holes are clockwise. In each ring, the last corner is joined to the first.
struct Outline {
    std::vector<Vec2> outer;
    std::vector<std::vector<Vec2>> holes;
};

/// Parses a polygon in the format WKT (well-known text), POLYGON((x y, ...), (...)): the outer
/// ring, followed by the holes. Rings may have either direction; repeating the first corner at the
/// end is optional, and the text may have several lines. Throws std::invalid_argument, with the
/// reason, if the text is not a polygon or if the polygon is not valid. For example, a polygon is
/// not valid if it crosses itself, or if its area is less than 1e-9 of the square of the longer
/// side of its bounding box.
Outline outline_from_wkt(std::string text);

/// Returns the unit disc around the origin as a regular polygon of 360 sides.
Outline disc_outline();

/// Returns a rectangle of height 1 whose lower left corner is the origin. `aspect` is its width
/// divided by its height.
Outline rectangle_outline(double aspect);

/// Returns the area within the outer ring minus the area of the holes.
double outline_area(const Outline& outline);

/// A rectangle whose sides are parallel to the axes.
struct Box {
    Vec2 low{0.0, 0.0};
    Vec2 high{0.0, 0.0};

    Vec2 size() const { return high - low; }
};

/// Returns the common bounding box of the outlines that are the parts of a shape. Precondition:
/// there is a part.
Box bounding_box(std::span<const Outline> parts);

/// Returns the width of bounding_box(parts), divided by its height. Precondition: there is a part.
double bounding_aspect(std::span<const Outline> parts);

/// Returns the centroid of the region.
Vec2 outline_centroid(const Outline& outline);

/// Returns true if the point is inside the outer ring and in no hole. Points on the boundary count
/// as outside.
bool is_inside(const Outline& outline, const Vec2& point);

/// Returns the parts of a convex polygon that are within the outline, each counter-clockwise. If a
/// hole of the outline is entirely within one part, the hole is ignored.
std::vector<std::vector<Vec2>> clipped(const Outline& outline, const std::vector<Vec2>& polygon);

}  // namespace foam
