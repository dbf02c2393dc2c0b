// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns a mesh as a binary STL file, in millimeters. The header has at most 80 bytes of the
/// title, in ASCII.
std::string to_stl(const Mesh& mesh, std::string_view title);

}  // namespace foam::texgen
