// SPDX-License-Identifier: Apache-2.0

#include "texgen/preset/camera_options.h"

#include "texgen/keys/value_kinds.h"

namespace foam::texgen {

Keys<CameraOptions> camera_keys() {
    return {key("zoom",
                Reals{0.01, 1000.0},
                "1 fits the patch of the first frame into the image; larger is closer",
                &CameraOptions::zoom)
                .only_for("foam.domain", {"patch"}),
            key("center",
                Points{{-10.0, 10.0}},
                "what comes to the middle: a place in the image of zoom 1, in parts of it from "
                "its lower left",
                &CameraOptions::center)
                .only_for("foam.domain", {"patch"}),
            key("margin",
                Reals{0.0, 0.45},
                "left free around the patch at zoom 1, in parts of the image's shorter side",
                &CameraOptions::margin)
                .only_for("foam.domain", {"patch"})};
}

}  // namespace foam::texgen
