// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/page.h"

#include <utility>
#include <vector>

namespace foam::texgen {

/// Returns the arc, translated by a vector.
inline DrawnArc moved_by(const DrawnArc& arc, const Vec2& translation) {
    return {arc.tail + translation, arc.head + translation, arc.half_angle};
}

/// A periodic copy of an arc on a torus.
struct ArcCopy {
    DrawnArc arc;
    LatticeOffset offset;  // translation from the original arc to the copy
};

/// Returns the periodic copies of an arc that come within `reach` millimeters of the tile. Copies
/// that are slightly farther away may be among them. Precondition: the domain of the page is not
/// the plane.
std::vector<ArcCopy> copies_near_tile(const DrawnArc& arc, const Page& page, double reach);

/// Returns those parts of the periodic copies of an arc that are outside of the tile and come
/// within `reach` millimeters of it. Parts that are slightly farther away may be among them.
/// Precondition: the domain of the page is not the plane.
std::vector<DrawnArc> parts_beyond_tile(const DrawnArc& arc, const Page& page, double reach);

}  // namespace foam::texgen
