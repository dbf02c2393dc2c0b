// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film.h"

#include "texgen/maps/film_look.h"

namespace foam::texgen {

NumberPixels draw_film(FrameLayers& layers, const AlbedoOptions& options) {
    return {film_cover(layers, options), 0.0, 1.0};
}

}  // namespace foam::texgen
