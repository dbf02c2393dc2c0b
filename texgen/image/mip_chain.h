// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/image/picture.h"

#include <vector>

namespace foam::texgen {

/// The meaning of the samples of a picture of codes, which decides how they are averaged.
enum class TexelMeaning {
    Numbers,  // colors (if the metadata of the picture say so) or other numbers
    Normals,  // components of unit vectors; the smallest code stands for -1, the largest for 1
    Ids,      // integers, which cannot be averaged
};

/// Returns the mip levels of a picture of codes, from its full size to 1 x 1 pixels. Each level has
/// half the width and height of the level before, rounded down, but at least 1. The samples of a
/// pixel are computed from the area that the pixel covers:
///
/// - Colors are averaged as light, weighted by their opacity if they have one.
/// - Other numbers are averaged as they are (mean_level).
/// - Normals are averaged as vectors, and the mean is scaled to unit length.
/// - Ids are not averaged: one of the ids in the area is chosen (central_level).
///
/// If the picture tiles, all levels tile. The first level is the picture itself. Precondition: the
/// picture has one group of codes; normals have three channels.
std::vector<Picture> mip_chain(const Picture& picture, TexelMeaning meaning);

}  // namespace foam::texgen
