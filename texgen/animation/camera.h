// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "core/foam/frame.h"
#include "texgen/preset/preset.h"
#include "texgen/raster/coords/raster_grid.h"

namespace foam::texgen {

/// Returns the view of a patch, which all frames share. With the default center and zoom, the
/// bounding box of the first frame's bubbles is centered in the image and as large as
/// `camera.margin` allows. `camera.center` selects another center, in fractions of the image of
/// this default view, and `camera.zoom` then magnifies the view. If the first frame has no bubbles,
/// the default view is centered at the origin and shows one foam unit as one pixel.
View camera_view(const Frame& first, const ImageOptions& image, const CameraOptions& camera);

}  // namespace foam::texgen
