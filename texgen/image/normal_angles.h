// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <vector>

namespace foam::texgen {

/// Returns true if the pixels of a picture can be normals: it has exactly three channels.
bool can_hold_normals(const Picture& picture);

/// Returns for each pixel, row by row from the bottom, the angle in degrees between the normals
/// that the two pictures have at this pixel. If samples are codes (integers, as in a PNG), the
/// smallest code represents the coordinate -1 of a normal, and the largest code represents 1. Other
/// samples are the coordinates themselves. Normals need not have unit length. The angle is 0 if the
/// samples are equal (NaN equals NaN), and 180 if they differ and a normal is zero or not finite.
/// Preconditions: can_hold_normals is true for both pictures; they have the same size and channels.
std::vector<double> normal_angles(const Picture& a, const Picture& b);

}  // namespace foam::texgen
