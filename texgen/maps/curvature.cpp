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
double curvature_at(const ReliefSection& section, double smooth, double radius) {
    const double distance = section.distance(smooth);
    const double outside =
        section.height_along(distance - radius) + section.height_along(distance + radius);
    return (2.0 * section.height_along(distance) - outside) / (radius * radius);
}

}  // namespace

Keys<CurvatureOptions> curvature_keys() {
    return {key("radius",
                Reals{0.001, 10.0},
                "distance, in bubble diameters, at which the heights on both sides of a point are "
                "compared with the height of the point; a larger distance ignores finer details",
                &CurvatureOptions::radius)
                .in(kReliefDiameters),
            key("full",
                RealsOrAuto{1e-6, 1e6, CurvatureOptions().full},
                "curvature that a PNG stores as its largest code; code 0 stands for -full; "
                "\"auto\" fits the whole animation",
                &CurvatureOptions::full)
                .in("per mean bubble diameter, selected by relief.mean_bubble")};
}

NumberPixels draw_curvature(FrameLayers& layers,
                            const ReliefSource& source,
                            const CurvatureOptions& options) {
    // The section is flat beyond its foot. The curvature at a point depends on heights up to
    // options.radius away, so distances up to the foot plus this radius are needed.
    const Relief relief(layers, source, Relief::kFoot + options.radius / source.relief.width);
    const double radius = options.radius * relief.diameter();
    Image<float> image(layers.grid().width, layers.grid().height, 1);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        const double unit = relief.unit(k);
        if (unit > 0.0) {
            const double curvature =
                curvature_at(relief.section(), relief.smooth(k), radius / unit) / unit;
            image.samples()[k] =
                static_cast<float>(relief.strength() * curvature * relief.diameter());
        }
    }
    return {std::move(image), -options.full.value, options.full.value};
}

}  // namespace foam::texgen
