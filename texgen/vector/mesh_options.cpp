// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/mesh_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<MeshOptions> mesh_keys() {
    using Options = MeshOptions;
    constexpr Choices<MeshKind, 3> kKinds = {
        {{{"auto", MeshKind::Auto}, {"relief", MeshKind::Relief}, {"walls", MeshKind::Walls}}}};
    const std::vector<std::string> meshes = {"*.stl", "*.glb"};
    return {key("kind",
                kKinds,
                "what STL and GLB files show: a slab with the relief that the map height shows, or "
                "the lines of vector.content as walls; auto shows walls if these lines are of a "
                "maze or of contours, else the relief",
                &Options::kind)
                .used_with("output.pattern", meshes),
            key("base_mm",
                Reals{.low = 0.01, .high = 1000.0, .or_zero = true},
                "thickness in millimeters of the slab under the lowest point of a relief, or of "
                "the plate under walls; 0 makes walls without a plate; a relief needs at "
                "least 0.01",
                &Options::base_mm)
                .in("millimeters")
                .used_with("output.pattern", meshes),
            key("relief_mm",
                Reals{.low = 0.001, .high = 1000.0, .or_zero = true},
                "height in millimeters of the highest point of a relief above its lowest point; 0 "
                "keeps the true scale",
                &Options::relief_mm)
                .in("millimeters")
                .used_with("output.pattern", meshes),
            key("wall_mm",
                Reals{0.01, 1000.0},
                "height in millimeters of walls above the plate",
                &Options::wall_mm)
                .in("millimeters")
                .used_with("output.pattern", meshes),
            key("tolerance_mm",
                Reals{0.001, 10.0},
                "largest distance in millimeters between an arc of a wall and the polygon that "
                "replaces it",
                &Options::tolerance_mm)
                .in("millimeters")
                .used_with("output.pattern", meshes)};
}

}  // namespace foam::texgen
