// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/preset/preset.h"
#include "texgen/raster/coords/raster_grid.h"

namespace foam::texgen {

/// Returns the view of a patch, which all frames share. At a zoom of 1 the first frame is centered
/// in the image and as large as the margin allows. If the first frame is empty, a foam unit at a
/// zoom of 1 is a pixel.
View camera_view(const Frame& first, const ImageOptions& image, const CameraOptions& camera);

}  // namespace foam::texgen
