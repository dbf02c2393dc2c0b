#pragma once

#include "core/foam/outline.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// The domain of a foam: a torus, which tiles, or the plane, where a patch has a free surface.
enum class FoamKind { Torus, Patch };

/// The kind of a foam and, of a patch, the outline it is seeded in. The size of the outline follows
/// from the number of bubbles, whose mean area is 1.
struct FoamShape {
    FoamKind kind = FoamKind::Torus;
    std::string outline = "disc";  // "rectangle", or a polygon as WKT
    double outline_aspect = 1.0;   // factor on x; discs and rectangles are as wide as high before
};

Keys<FoamShape> shape_keys();

/// Returns the outline of a patch at some scale. Throws std::invalid_argument for an invalid text
/// or a polygon without area.
foam::Outline outline_of(const FoamShape& shape);

}  // namespace foam::texgen
