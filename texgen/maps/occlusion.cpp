// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/occlusion.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/relief.h"

#include <cstddef>

namespace foam::texgen {

Keys<OcclusionOptions> occlusion_keys() {
    return {key("strength",
                Reals{0.0, 100.0},
                "exponent of the visible fraction of the sky; larger values darken the map",
                &OcclusionOptions::strength)};
}

Image<float> occlusion_of(const Relief& relief, const SkyLookup& sky) {
    Image<float> image(relief.distance().width(), relief.distance().height(), 1);
    relief.for_all_pixels([visible = image.samples().data(), sky](
                              const auto& section, double smooth, double unit, std::size_t k) {
        const double fraction = sky.at(section.distance(smooth));
        visible[k] = static_cast<float>(unit > 0.0 ? fraction : 1.0);
    });
    return image;
}

NumberPixels draw_occlusion(FrameLayers& layers,
                            const ReliefSource& source,
                            const OcclusionOptions& options) {
    const Relief relief(layers, source, ReliefSection::kSkyReach);
    const VisibleSky sky(relief.section(), relief.strength(), options.strength);
    return {occlusion_of(relief, sky.lookup()), 0.0, 1.0};
}

}  // namespace foam::texgen
