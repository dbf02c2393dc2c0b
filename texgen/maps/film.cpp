// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/film.h"

#include "texgen/maps/film_coverage.h"

namespace foam::texgen {

NumberPixels draw_film(FrameLayers& layers, const AlbedoOptions& options) {
    return {film_coverage(layers, options), 0.0, 1.0};
}

}  // namespace foam::texgen
