// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/opacity.h"

#include "texgen/maps/film_look.h"

namespace foam::texgen {

NumberPixels draw_opacity(FrameLayers& layers, const AlbedoOptions& options) {
    return {foam_cover(layers, options), 0.0, 1.0};
}

}  // namespace foam::texgen
