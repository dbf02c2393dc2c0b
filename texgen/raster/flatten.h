#pragma once

#include "core/geometry/film_arc.h"
#include "texgen/raster/coords/fixed_point.h"

#include <vector>

namespace foam::texgen {

/// Appends the inner points of a chain of straight edges that stands for the arc (in pixels),
/// rounded to subpixels: `origin` plus the point relative to the arc's tail. The ends of the arc
/// are the caller's.
///
/// The inner points lie a little outside the arc, so that chain and arc enclose the same area, but
/// for rounding; the area between them is below 1/1000 pixel in any pixel. A nearly straight arc
/// has no inner points, nor has one of no length.
void append_inner_points(const FilmArc& arc,
                         const Vec2& tail,
                         SubpixelPoint origin,
                         std::vector<SubpixelPoint>& points);

/// The same without rounding: the arc's tail plus the points relative to it.
void append_inner_points(const FilmArc& arc, const Vec2& tail, std::vector<Vec2>& points);

}  // namespace foam::texgen
