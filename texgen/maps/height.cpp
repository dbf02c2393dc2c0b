// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/height.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/relief.h"

#include <utility>

namespace foam::texgen {

Keys<HeightOptions> height_keys() {
    return {key("full",
                Reals{1e-6, 1e6},
                "height that a PNG stores as its largest code, in bubble diameters",
                &HeightOptions::full)
                .in(kReliefDiameters)};
}

NumberPixels draw_height(FrameLayers& layers,
                         const ReliefSource& source,
                         const HeightOptions& options) {
    const Relief relief(layers, source, Relief::kFoot);
    Image<float> image(layers.grid().width, layers.grid().height, 1);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        image.samples()[k] = static_cast<float>(relief.height(k) / relief.diameter());
    }
    return {std::move(image), 0.0, options.full};
}

}  // namespace foam::texgen
