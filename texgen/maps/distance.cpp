// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/distance.h"

#include "core/parallel/simd_level.h"
#include "texgen/maps/frame_layers.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace foam::texgen {

Keys<DistanceOptions> distance_keys() {
    constexpr Choices<DistanceKind> kKinds = {
        {{{"plain", DistanceKind::Plain}, {"signed", DistanceKind::Signed}}}};
    constexpr Choices<DistanceUnit> kUnits = {
        {{{"foam", DistanceUnit::Foam}, {"px", DistanceUnit::Pixels}}}};
    return {key("kind",
                kKinds,
                "plain: distance from the center line of the nearest film, 0 around a patch; "
                "signed: distance from the edge of this film on the side of the bubble, negative "
                "inside films and around a patch",
                &DistanceOptions::kind),
            key("unit", kUnits, "foam units or pixels", &DistanceOptions::unit),
            key("full",
                RealsOrAuto{1e-6, 1e6, DistanceOptions().full},
                "distance at the value 1 (white) of a PNG, in the unit distance.unit; 0 (black) "
                "stands for 0, or for -full if distance.kind is \"signed\"; \"auto\" fits it to "
                "the largest distance in the whole animation",
                &DistanceOptions::full)
                .in("foam units or pixels, selected by distance.unit")};
}

NumberPixels draw_distance(FrameLayers& layers,
                           const DistanceOptions& options,
                           const AlbedoOptions& films) {
    const DistanceField& field = layers.distance();
    const Domain& domain = layers.frame().domain;
    const bool is_signed = options.kind == DistanceKind::Signed;
    const double edge = is_signed ? 0.5 * film_width_in_pixels(films, layers.grid(), domain) : 0.0;
    const double unit =
        options.unit == DistanceUnit::Foam ? pixels_per_unit(layers.grid(), domain) : 1.0;
    const double low = is_signed ? -options.full.value : 0.0;
    Image<float> image(layers.grid().width, layers.grid().height, 1);
    at_simd_level([outwards = is_signed ? -1.0 : 0.0,
                   edge,
                   unit,
                   low,
                   surroundings = layers.surroundings_id(),
                   count = image.samples().size(),
                   distances = field.distance.samples().data(),
                   ids = field.ids.samples().data(),
                   to = image.samples().data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const auto distance = static_cast<double>(distances[k]);
            const double factor = ids[k] == surroundings ? outwards : 1.0;
            const double number = (factor * distance - edge) / unit;
            // A patch whose last bubble has vanished has no film, so the distance is infinite. The
            // EXR writer rejects infinite numbers.
            to[k] = static_cast<float>(std::isfinite(distance) ? number : low);
        }
    });
    return {std::move(image), low, options.full.value};
}

}  // namespace foam::texgen
