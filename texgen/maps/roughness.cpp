// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/roughness.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/identity_number.h"

#include <algorithm>

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
    return {fill_numbers(layers, {cells, options.film}, films), 0.0, 1.0};
}

}  // namespace foam::texgen
