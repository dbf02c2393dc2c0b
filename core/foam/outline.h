#pragma once

#include "core/geometry/vec2.h"

#include <string>
#include <vector>

namespace foam {

/// A polygon with holes, in any units: where a patch is seeded. The outer ring is
/// counter-clockwise, holes are clockwise; the last corner is joined to the first.
struct Outline {
    std::vector<Vec2> outer;
    std::vector<std::vector<Vec2>> holes;
};

/// Of a WKT text, POLYGON((x y, ...), (...)). Rings may go either way, closed or not. Throws
/// std::invalid_argument where it is none, or crosses itself.
Outline outline_from_wkt(const std::string& text);

/// A regular polygon of many sides.
Outline disc_outline();

/// Width over height.
Outline rectangle_outline(double aspect);

/// Within the outer ring, without the holes.
double outline_area(const Outline& outline);

bool is_inside(const Outline& outline, const Vec2& point);

/// The parts of a convex polygon, counter-clockwise, that lie within the outline. A hole that lies
/// within one part is left out.
std::vector<std::vector<Vec2>> clipped(const Outline& outline, const std::vector<Vec2>& polygon);

}  // namespace foam
