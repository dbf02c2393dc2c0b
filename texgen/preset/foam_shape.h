// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// The domain of a foam: a torus, which tiles, or the plane, where a patch has a free surface.
enum class FoamKind { Torus, Patch };

/// The kind of a foam and, for a patch, the outline in which it is seeded. The size of the outline
/// follows from the number of bubbles, whose mean area is 1.
struct FoamShape {
    FoamKind kind = FoamKind::Torus;
    std::string outline = "disc";  // "disc", "rectangle", or a polygon as WKT
    double outline_aspect = 1.0;   // stretches the outline in x; at 1 a disc is a circle and
                                   // a rectangle is a square
};

Keys<FoamShape> shape_keys();

/// Returns the outline of a patch. Its scale is arbitrary. Throws std::invalid_argument for an
/// invalid text or a polygon without area.
foam::Outline outline_of(const FoamShape& shape);

}  // namespace foam::texgen
