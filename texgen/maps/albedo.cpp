#include "texgen/maps/albedo.h"

#include "core/foam/measure.h"
#include "core/foam/statistics.h"
#include "texgen/image/color.h"
#include "texgen/image/colormap.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/quantize.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {

std::vector<double> pressures_of(const Frame& frame, PressureUnit unit) {
    const double length = unit == PressureUnit::Seed ? 1.0 : std::sqrt(mean_area(frame));
    const double scale = length / frame.film_tension;
    return per_bubble<double>(
        frame,
        [&](BubbleId bubble) { return frame.bubbles[bubble].pressure * scale; },
        [&](const LoneBubble& bubble) { return frame.film_tension / lone_radius(bubble) * scale; });
}

double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Torus& torus) {
    if (options.film_unit == WidthUnit::Pixels) {
        return options.film_width;
    }
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;  // of a circle of area 1
    return options.film_width * diameter * pixels_per_unit(grid, torus);
}

ColorPixels draw_albedo(FrameLayers& layers, const AlbedoOptions& options) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument("the low end of the pressures must lie below the high end");
    }
    const ColorMap& colormap = find_colormap(options.colormap);
    const double range = options.pressure_high - options.pressure_low;
    PerBubble<LinearRgb> colors;
    for (const double pressure : pressures_of(layers.frame(), options.pressure_unit)) {
        colors.push_back(colormap.at((pressure - options.pressure_low) / range));
    }
    const double width = film_width_in_pixels(options, layers.grid(), layers.frame().torus);
    return fill_colors(layers, colors, to_linear(parse_color(options.film_color)), width);
}

Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads) {
    const FoamRecord record;
    FrameLayers layers({frame, record}, grid, threads);
    return srgb_codes(draw_albedo(layers, options));
}

}  // namespace foam::texgen
