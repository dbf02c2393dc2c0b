// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/height.h"

#include "texgen/maps/relief.h"

#include <utility>

namespace foam::texgen {

Keys<HeightOptions> height_keys() {
    return {key("full",
                RealsOrAuto{1e-6, 1e6, HeightOptions().full},
                "height at the value 1 (white) of a PNG, in bubble diameters; \"auto\" fits it to "
                "the largest height in the whole animation",
                &HeightOptions::full)
                .in(kReliefDiameters)};
}

NumberPixels draw_height(FrameLayers& layers,
                         const ReliefSource& source,
                         const HeightOptions& options) {
    const Relief relief(layers, source, Relief::kFoot);
    Image<float> image = relief.heights();
    for (float& height : image.samples()) {
        height = static_cast<float>(static_cast<double>(height) / relief.diameter());
    }
    return {std::move(image), 0.0, options.full.value};
}

double height_unit(const FrameLayers& layers, const ReliefOptions& options) {
    const Frame& frame = layers.frame();
    return diameter_of(options.mean_bubble, frame) * pixels_per_unit(layers.grid(), frame.domain) /
           layers.grid().width;
}

}  // namespace foam::texgen
