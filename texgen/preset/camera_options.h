#pragma once

#include "texgen/keys/key.h"

#include <array>

namespace foam::texgen {

/// The part of the plane that images of a patch show, the same in every frame. It follows from the
/// patch in the first frame.
struct CameraOptions {
    double zoom = 1.0;     // 1 fits the whole patch
    double margin = 0.05;  // around it at zoom 1, in fractions of the image's shorter side
    // The point that comes to the middle of the image, in fractions of the image of zoom 1 from its
    // lower left corner.
    std::array<double, 2> center = {0.5, 0.5};
};

Keys<CameraOptions> camera_keys();

}  // namespace foam::texgen
