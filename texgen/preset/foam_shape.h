// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/keys/key.h"
#include "texgen/pictures/outline_file.h"

#include <memory>
#include <string>
#include <vector>

namespace foam::texgen {

/// The kinds of foams. A foam on a torus gives images that tile, unless the torus is sheared. A
/// patch is a foam in the plane with a free surface.
enum class FoamKind { Torus, Patch };

/// The kind of a foam and, for a patch, the outline in which it is seeded. The size of the outline
/// follows from the number of bubbles, whose mean area is 1.
struct FoamShape {
    FoamKind kind = FoamKind::Torus;
    // "disc", "rectangle", a polygon as WKT (well-known text), or the path of a file that contains
    // an outline (outline_file.h in texgen/pictures).
    std::string outline = "disc";
    double outline_aspect = 1.0;  // factor that stretches the outline in x; at 1 a disc is a circle
                                  // and a rectangle is a square
    // The outline in the file that `outline` names; null if `outline` names no file. The file is
    // read together with the key foam.outline, so that a bad file is an error of the preset.
    std::shared_ptr<const FileOutline> file_outline{};
};

Keys<FoamShape> shape_keys();

/// Returns the outline of a patch, stretched in x by `outline_aspect`: one element per connected
/// part. The returned outline has an arbitrary scale; seeding scales it to the number of bubbles.
/// Throws std::invalid_argument if `outline` is not an allowed text, or if a part has no area.
/// Precondition: `file_outline` is not null if `outline` names a file.
std::vector<foam::Outline> outline_of(const FoamShape& shape);

}  // namespace foam::texgen
