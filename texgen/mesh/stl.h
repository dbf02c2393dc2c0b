// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/mesh/mesh.h"

#include <string>
#include <string_view>

namespace foam::texgen {

/// Returns a mesh as a binary STL file, in millimeters. The header of 80 bytes is a fixed text and
/// the title, which is cut off if it is too long. Bytes of the title that are not printable ASCII
/// become '?'.
std::string to_stl(const Mesh& mesh, std::string_view title);

}  // namespace foam::texgen
