// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/camera_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<CameraOptions> camera_keys() {
    return {key("zoom",
                Reals{0.01, 1000.0},
                "magnification; 1 fits the patch of the first frame into the image",
                &CameraOptions::zoom)
                .only_for("foam.domain", {"patch"}),
            key("center",
                Points{{-10.0, 10.0}},
                "point that is shown in the center of the image, given as its position in the "
                "image at zoom 1: fractions of the width and height from the lower left corner",
                &CameraOptions::center)
                .in("fraction of the image width and height")
                .only_for("foam.domain", {"patch"}),
            key("margin",
                Reals{0.0, 0.45},
                "free margin around the patch at zoom 1, as a fraction of the shorter side of the "
                "image",
                &CameraOptions::margin)
                .in("fraction of the shorter side of the image")
                .only_for("foam.domain", {"patch"})};
}

}  // namespace foam::texgen
