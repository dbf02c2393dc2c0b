// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/metallic.h"

#include "texgen/keys/value_kinds.h"
#include "texgen/maps/film_coverage.h"

namespace foam::texgen {

Keys<MetallicOptions> metallic_keys() {
    return {key("cell",
                kFractions,
                "metalness of bubbles: 1 for a metal, 0 for all other materials",
                &MetallicOptions::cell),
            key("film",
                kFractions,
                "metalness of films, whose width is albedo.film_width",
                &MetallicOptions::film)};
}

NumberPixels draw_metallic(FrameLayers& layers,
                           const MetallicOptions& options,
                           const AlbedoOptions& film_shape) {
    const auto cell = [&](const auto&) { return options.cell; };
    const auto cells = per_bubble<double>(layers.frame(), cell, cell);
    return {fill_numbers(layers, {cells, options.film}, film_shape), 0.0, 1.0};
}

}  // namespace foam::texgen
