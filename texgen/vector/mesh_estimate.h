// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/vector/vector_source.h"

namespace foam::texgen {

/// The expected cost of one mesh.
struct MeshEstimate {
    double file_bytes = 0.0;    // size of the file
    double memory_bytes = 0.0;  // peak memory of building and encoding the mesh
};

/// Estimates a mesh before its frame is known. The numbers are usually right within a factor of
/// 1.5. `bubbles` is the number of bubbles of the foam, which is at least 1. `is_glb` selects GLB
/// instead of STL.
MeshEstimate estimated_mesh(const VectorSettings& settings, int bubbles, bool is_glb);

}  // namespace foam::texgen
