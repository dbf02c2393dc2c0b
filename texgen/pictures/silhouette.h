// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/outline.h"
#include "texgen/pictures/source_picture.h"

#include <vector>

namespace foam::texgen {

/// Returns the silhouette of a picture as outlines (traced_outlines). If any pixel has an opacity
/// below one half, the silhouette is the opaque part: the pixels with an opacity of at least one
/// half. Otherwise it is the dark part: the pixels whose lightness, the sRGB encoding of their
/// luminance, is at most one half. If the picture has more than kOutlineGridPoints pixels, squares
/// of pixels are averaged first. The result is empty if no part of the picture is opaque or dark.
std::vector<foam::Outline> silhouette(const SourcePicture& picture);

}  // namespace foam::texgen
