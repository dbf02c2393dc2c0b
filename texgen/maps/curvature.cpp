// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/curvature.h"

#include "texgen/maps/relief.h"

#include <cstddef>
#include <utility>

namespace foam::texgen {

namespace {

// Returns the curvature of a section at a point whose smooth distance from the film is `smooth`, by
// the formula in curvature.h. The result is for ReliefOptions::strength = 1 and is not multiplied
// by the diameter of the mean bubble. All lengths are in the unit of the section (ReliefSection).
template <class Section>
double curvature_at(const Section& section, double smooth, double radius) {
    const double distance = section.distance(smooth);
    const double both_sides =
        height_along(section, distance - radius) + height_along(section, distance + radius);
    return (2.0 * height_along(section, distance) - both_sides) / (radius * radius);
}

}  // namespace

Keys<CurvatureOptions> curvature_keys() {
    return {key("radius",
                Reals{0.001, 10.0},
                "distance, in bubble diameters, at which the heights on both sides of a point are "
                "compared with the height of the point; a large distance shows coarse shapes",
                &CurvatureOptions::radius)
                .in(kReliefDiameters),
            key("full",
                RealsOrAuto{1e-6, 1e6, CurvatureOptions().full},
                "curvature at the value 1 (white) of a PNG, per bubble diameter; 0 (black) stands "
                "for -full; \"auto\" fits it to the largest curvature in the whole animation",
                &CurvatureOptions::full)
                .in("per mean bubble diameter, selected by relief.mean_bubble")};
}

NumberPixels draw_curvature(FrameLayers& layers,
                            const ReliefSource& source,
                            const CurvatureOptions& options) {
    // The section is flat beyond its foot. The curvature at a point depends on heights up to
    // options.radius away, so distances up to the foot plus this radius are needed.
    const Relief relief(layers, source, Relief::kFoot + options.radius / source.relief.width);
    Image<float> image(layers.grid().width, layers.grid().height, 1);
    relief.for_all_pixels([curvatures = image.samples().data(),
                           radius = options.radius * relief.diameter(),
                           factor = relief.strength() * relief.diameter()](
                              const auto& section, double smooth, double unit, std::size_t k) {
        const double curvature = factor * curvature_at(section, smooth, radius / unit) / unit;
        curvatures[k] = static_cast<float>(unit > 0.0 ? curvature : 0.0);
    });
    return {std::move(image), -options.full.value, options.full.value};
}

}  // namespace foam::texgen
