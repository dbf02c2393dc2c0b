// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/keys/key.h"

#include <string>

namespace foam::texgen {

/// The kinds of foams: a foam on a torus, whose images tile, or a patch, a foam in the plane with a
/// free surface.
enum class FoamKind { Torus, Patch };

/// The kind of a foam and, for a patch, the outline in which it is seeded. The size of the outline
/// follows from the number of bubbles, whose mean area is 1.
struct FoamShape {
    FoamKind kind = FoamKind::Torus;
    std::string outline = "disc";  // "disc", "rectangle", or a polygon as WKT (well-known text)
    double outline_aspect = 1.0;   // factor that stretches the outline in x; at 1 a disc is a
                                   // circle and a rectangle is a square
};

Keys<FoamShape> shape_keys();

/// Returns the outline of a patch, stretched in x by `outline_aspect`. The scale of the outline is
/// arbitrary. Throws std::invalid_argument if `outline` is not an allowed text or is a polygon
/// without area.
foam::Outline outline_of(const FoamShape& shape);

}  // namespace foam::texgen
