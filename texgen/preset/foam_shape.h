#pragma once

#include "core/foam/outline.h"

#include <string>

namespace foam::texgen {

/// Where a foam lies: around a torus, which tiles, or as a patch with a free surface in the plane.
enum class FoamKind { Torus, Patch };

/// The kind of a foam and, of a patch, the shape it is seeded in. Its size follows from the number
/// of bubbles, whose mean area is 1.
struct FoamShape {
    FoamKind kind = FoamKind::Torus;
    std::string outline = "disc";  // "rectangle", or a polygon as WKT
    double outline_aspect = 1.0;   // stretches the outline in x; discs and rectangles are as wide
                                   // as high before
};

/// Of any size. Throws std::invalid_argument for a text that is none of these, or a polygon without
/// an area.
foam::Outline outline_of(const FoamShape& shape);

}  // namespace foam::texgen
