#include "texgen/maps/opacity.h"

#include "texgen/maps/cell_fill.h"

namespace foam::texgen {

NumberPixels draw_opacity(FrameLayers& layers, const AlbedoOptions& options) {
    const double width = film_width_in_pixels(options, layers.grid(), layers.frame().torus);
    return {fill_cover(layers, Part::Foam, width), 0.0, 1.0};
}

}  // namespace foam::texgen
