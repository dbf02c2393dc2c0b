// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/roughness.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/identity_number.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace foam::texgen {

Keys<RoughnessOptions> roughness_keys() {
    return {key("cell", kFractions, "roughness of bubbles; 0 is a mirror", &RoughnessOptions::cell),
            key("film",
                kFractions,
                "roughness of films, whose width is albedo.film_width",
                &RoughnessOptions::film),
            key("variation",
                kFractions,
                "width of the range around roughness.cell in which every bubble has a roughness of "
                "its own",
                &RoughnessOptions::variation)};
}

NumberPixels draw_roughness(FrameLayers& layers,
                            const RoughnessOptions& options,
                            const AlbedoOptions& films) {
    const auto roughness_of = [&](BubbleIdentity bubble) {
        const double number = identity_number(bubble, IdentityStream::First) - 0.5;
        return std::clamp(options.cell + options.variation * number, 0.0, 1.0);
    };
    const Frame& frame = layers.frame();
    const auto cells = per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return roughness_of(frame.bubbles[bubble].identity); },
        [&](const LoneBubble& bubble) { return roughness_of(bubble.identity); });
    if (films.film_profile == FilmProfile::Even) {
        const double width = film_width_in_pixels(films, layers.grid(), frame.domain);
        return {fill_numbers(layers, {cells, options.film}, width), 0.0, 1.0};
    }
    Image<float> image = fill_numbers(layers, cells);
    const Image<float> coverage = film_coverage(layers, films);
    const Image<float> foam = foam_coverage(layers, films, coverage);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        const float whole = foam.samples()[k];
        const float part = whole > 0.0F ? coverage.samples()[k] / whole : 0.0F;
        image.samples()[k] = std::lerp(image.samples()[k], static_cast<float>(options.film), part);
    }
    return {std::move(image), 0.0, 1.0};
}

}  // namespace foam::texgen
