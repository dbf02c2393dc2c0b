// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "texgen/keys/key.h"

#include <array>

namespace foam::texgen {

/// The options that select which part of the plane the images of a patch show. This part is
/// computed from the patch in the first frame and is the same in all frames.
struct CameraOptions {
    /// The magnification. At 1, the whole patch of the first frame fits into the image.
    double zoom = 1.0;
    /// The space around the patch at zoom 1, as a fraction of the shorter side of the image.
    double margin = 0.05;
    /// The point that is shown in the middle of the image. It is given by its position in the image
    /// at zoom 1, in fractions of the width and height from the lower left corner.
    std::array<double, 2> center = {0.5, 0.5};
};

Keys<CameraOptions> camera_keys();

}  // namespace foam::texgen
