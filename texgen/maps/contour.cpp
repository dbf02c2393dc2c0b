// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/contour.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/arcs_of_films.h"
#include "texgen/maps/film_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace foam::texgen {

Keys<ContourOptions> contour_keys() {
    using Options = ContourOptions;
    return {key("levels",
                Integers{2, 256},
                "number of equal levels into which the tones of the map `pressure` are divided; "
                "lines run between bubbles of different levels, and around a patch",
                &Options::levels)
                .in("levels"),
            key("width",
                Reals{0.0, 10.0},
                "full width of lines, in diameters of a mean bubble of the seeded foam",
                &Options::width)
                .in("mean bubble diameters of the seeded foam"),
            key("line_color", Colors{}, "sRGB color of lines", &Options::line_color)
                .unused_with("contour.width", {"0.0"}),
            key("ground_color", Colors{}, "sRGB color of bubbles", &Options::ground_color)};
}

Indexed<FilmId, std::uint8_t> contour_films(const FrameLayers& layers,
                                            const ContourOptions& options,
                                            const PressureOptions& pressure) {
    const PerBubble<double> tones = pressure_tones(layers, pressure);
    const auto levels = static_cast<double>(options.levels);
    const auto level_of = [&](BubbleId bubble) {
        return std::clamp(std::floor(tones[index_of(bubble)] * levels), 0.0, levels - 1.0);
    };
    const Network& network = layers.frame().network;
    Indexed<FilmId, std::uint8_t> chosen(network.film_slots());
    for (const FilmId film : network.films()) {
        const HalfEdgeId side = forward_side(film);
        const bool is_line =
            network.is_outer(film) || level_of(network.left(side)) != level_of(network.right(side));
        chosen[film] = is_line ? 1 : 0;
    }
    return chosen;
}

ColorPixels draw_contour(FrameLayers& layers,
                         const ContourOptions& options,
                         const PressureOptions& pressure) {
    const Indexed<FilmId, std::uint8_t> chosen = contour_films(layers, options, pressure);
    const std::vector<PlacedArc> lines =
        arcs_of_films(layers.frame(), layers.grid(), layers.threads(), [&](FilmId film) {
            return chosen[film] != 0;
        });
    return paint_layers(
        layers,
        options.ground_color,
        std::array{PaintLayer{options.line_color, strokes_along(layers, lines, options.width)}});
}

}  // namespace foam::texgen
