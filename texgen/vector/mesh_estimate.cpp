// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/mesh_estimate.h"

#include "texgen/mesh/height_slab.h"
#include "texgen/vector/frame_mesh.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

namespace {

// Bytes per triangle, measured with one frame of sea_foam (loop.kind=none, one thread). The reliefs
// had 512 x 512 and 1024 x 1024 pixels. The walls were those of 1000 and 4000 bubbles, at
// tolerances of 0.02 and 0.001 mm.
struct BytesPerTriangle {
    double file;    // size of the file
    double memory;  // peak memory
};

BytesPerTriangle bytes_per_triangle(MeshKind kind, bool is_glb) {
    constexpr double kStlTriangle = 50.0;
    if (kind == MeshKind::Relief) {
        return is_glb ? BytesPerTriangle{24.0, 110.0} : BytesPerTriangle{kStlTriangle, 70.0};
    }
    return is_glb ? BytesPerTriangle{36.0, 200.0} : BytesPerTriangle{kStlTriangle, 150.0};
}

// Walls have about six arcs per bubble: both sides of three films. An arc of the length d has a
// number of parts that grows as sqrt(d / tolerance). Both constants are from the measurement
// described at BytesPerTriangle.
double wall_triangles(const VectorSettings& settings, int bubbles) {
    constexpr double kCornerTriangles = 24.0;
    constexpr double kArcTriangles = 3.1;
    const double bubble_size = settings.drawing.width_mm / std::sqrt(static_cast<double>(bubbles));
    return bubbles *
           (kCornerTriangles + kArcTriangles * std::sqrt(bubble_size / settings.mesh.tolerance_mm));
}

}  // namespace

MeshEstimate estimated_mesh(const VectorSettings& settings, int bubbles, bool is_glb) {
    const MeshKind kind = shown_kind(settings);
    const double triangles =
        kind == MeshKind::Relief
            ? static_cast<double>(slab_triangles(static_cast<std::size_t>(settings.width) + 1,
                                                 static_cast<std::size_t>(settings.height) + 1))
            : wall_triangles(settings, bubbles);
    const BytesPerTriangle bytes = bytes_per_triangle(kind, is_glb);
    return {bytes.file * triangles, bytes.memory * triangles};
}

}  // namespace foam::texgen
