#pragma once

#include "core/foam/frame.h"
#include "texgen/preset/preset.h"
#include "texgen/raster/coords/raster_grid.h"

namespace foam::texgen {

/// The view of a patch that the camera of a preset has from its first frame on: at a zoom of 1
/// everything fits the image, in its middle and as large as the margin allows. Where there is
/// nothing, a foam unit is a pixel.
View camera_view(const Frame& first, const ImageOptions& image, const CameraOptions& camera);

/// The point of the plane at a place of the image, in parts of its width and height from its lower
/// left corner.
Vec2 point_in_view(const View& view, const ImageOptions& image, const std::array<double, 2>& place);

}  // namespace foam::texgen
