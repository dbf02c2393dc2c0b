// SPDX-License-Identifier: Apache-2.0

#include "texgen/vector/mesh_estimate.h"

#include <gtest/gtest.h>

namespace foam::texgen {
namespace {

// A relief of 1024 x 1024 pixels as STL: 2 x 1024² triangles of the surface, 6 x 2048 of the sides
// and the bottom, 50 bytes each. Its file has 84 bytes more.
TEST(MeshEstimate, AReliefAsStlIsExact) {
    const MapOptions maps;
    const VectorOptions drawing;
    const MeshOptions mesh{.kind = MeshKind::Relief};
    const VectorSettings settings{maps, drawing, mesh, {"albedo"}, 1024, 1024};
    EXPECT_EQ(estimated_mesh(settings, 400, false).file_bytes,
              50.0 * (2.0 * 1024.0 * 1024.0 + 6.0 * 2048.0));
    EXPECT_LT(estimated_mesh(settings, 400, true).file_bytes,
              estimated_mesh(settings, 400, false).file_bytes);
}

// Four times as many parts per arc need a sixteenth of the tolerance.
TEST(MeshEstimate, WallsDependOnTheTolerance) {
    const MapOptions maps;
    const VectorOptions drawing;
    const MeshOptions coarse{.kind = MeshKind::Walls, .tolerance_mm = 0.0016};
    const MeshOptions fine{.kind = MeshKind::Walls, .tolerance_mm = 0.0001};
    const auto bytes = [&](const MeshOptions& mesh) {
        return estimated_mesh({maps, drawing, mesh, {"albedo"}, 64, 64}, 400, false).memory_bytes;
    };
    EXPECT_GT(bytes(fine), 3.0 * bytes(coarse));
    EXPECT_LT(bytes(fine), 4.0 * bytes(coarse));
}

}  // namespace
}  // namespace foam::texgen
