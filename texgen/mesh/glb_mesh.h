// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns a mesh as a binary glTF 2.0 file: positions in meters with y up, normals that make edges
/// look sharp (with_normals), and indices. `name` is the name of the mesh and of its node.
/// Precondition: the mesh has a triangle.
std::string to_glb(const Mesh& mesh, std::string_view name);

}  // namespace foam::texgen
