#include "texgen/maps/roughness.h"

#include "texgen/maps/cell_fill.h"
#include "texgen/maps/identity_number.h"

#include <algorithm>

namespace foam::texgen {

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
    const double width = film_width_in_pixels(films, layers.grid(), frame.torus);
    return {fill_numbers(layers, {cells, options.film}, width), 0.0, 1.0};
}

}  // namespace foam::texgen
