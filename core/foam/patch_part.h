// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/area_field.h"
#include "core/foam/foam.h"
#include "core/foam/outline.h"
#include "core/foam/patch_options.h"
#include "core/foam/polygon_mesh.h"
#include "core/foam/random.h"

#include <optional>
#include <span>
#include <vector>

namespace foam {

/// A part of an outline, scaled and placed in the middle of a torus of its own. The cells of the
/// part come from a Voronoi diagram of points within the part, called sites. The torus is at least
/// twice as wide and at least twice as high as the part. So a lattice copy of a site is never
/// nearer to a point within the part than the site itself. Copies therefore do not affect the cells
/// within the part.
struct PreparedPart {
    Outline outline;
    Domain domain;
    Vec2 shift{0.0, 0.0};  // from the position in the scaled outline to the position in the torus
    int bubbles = 1;       // the part's share of all bubbles, rounded, but at least 1
    std::optional<AreaField> areas{};  // stretched over the bounding box of the whole outline

    const AreaField* areas_or_null() const { return areas ? &*areas : nullptr; }
};

/// Prepares the parts of an outline. They are scaled to a total area of 1 per bubble. Parts get
/// bubbles in proportion to their areas or, if there is an area field, to the integrals of
/// 1 / field over the parts. Throws std::runtime_error if the share of a part is less than a tenth
/// of a bubble. Precondition: every part has an area.
std::vector<PreparedPart> prepare_parts(std::span<const Outline> parts,
                                        const PatchOptions& options);

/// Returns the mesh as a foam (foam_from_mesh). Throws std::runtime_error if the foam is not valid.
Foam valid_foam(const PolygonMesh& mesh);

/// The cells of a part, and the value of the area field at each cell (empty if there is no field).
struct PartCells {
    PolygonMesh mesh;
    std::vector<double> field{};
};

/// Returns the clipped Voronoi cells of random sites in a part. Slivers are merged into neighbors
/// (merge_slivers). Draws new sites until the cells are a valid foam. Throws std::runtime_error if
/// several draws give no valid foam. Precondition: the part has at least two bubbles.
PartCells draw_part(const PreparedPart& part, const PatchOptions& options, Random& random);

}  // namespace foam
