// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/opacity.h"

#include "texgen/maps/film_coverage.h"

namespace foam::texgen {

NumberPixels draw_opacity(FrameLayers& layers, const AlbedoOptions& options) {
    return {foam_coverage(layers, options), 0.0, 1.0};
}

}  // namespace foam::texgen
