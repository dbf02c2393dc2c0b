#include "texgen/maps/albedo.h"

#include "texgen/image/color.h"
#include "texgen/image/colormap.h"
#include "texgen/raster/fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace foam::texgen {

namespace {

constexpr double kLargestValue = 65535.0;

// Length of the film tension over the unit of pressure.
double pressure_unit_length(const Frame& frame, PressureUnit unit) {
    if (unit == PressureUnit::Seed) {
        return 1.0;
    }
    const auto bubbles = static_cast<double>(frame.bubbles.size());
    return std::sqrt(frame.torus.area() / bubbles);
}

std::array<std::uint16_t, 3> light(const LinearRgb& color) {
    const auto value = [](double x) {
        return static_cast<std::uint16_t>(std::lround(x * kLargestValue));
    };
    return {value(color.r), value(color.g), value(color.b)};
}

CellValues cell_values(const Frame& frame, const AlbedoOptions& options) {
    const ColorMap& colormap = find_colormap(options.colormap);
    const double unit = pressure_unit_length(frame, options.pressure_unit) / frame.film_tension;
    const double range = options.pressure_high - options.pressure_low;
    CellValues values{3, {}, {}};
    for (const FrameBubble& bubble : frame.bubbles) {
        const double t = (bubble.pressure * unit - options.pressure_low) / range;
        const auto color = light(colormap.at(t));
        values.cells.insert(values.cells.end(), color.begin(), color.end());
    }
    const auto film = light(to_linear(parse_color(options.film_color)));
    std::copy(film.begin(), film.end(), values.film.begin());
    return values;
}

// Code k stands for the light that rounds to it: up to where sRGB passes k + 1/2.
Encoding<std::uint8_t> make_srgb_encoding() {
    Encoding<std::uint8_t> encoding{};
    std::size_t value = 0;
    for (int code = 0; code < 256; ++code) {
        const double end =
            code < 255 ? srgb_to_linear((code + 0.5) / 255.0) * kLargestValue : kLargestValue + 1.0;
        for (; value < encoding.size() && static_cast<double>(value) < end; ++value) {
            encoding[value] = static_cast<std::uint8_t>(code);
        }
    }
    return encoding;
}

const Encoding<std::uint8_t>& srgb_encoding() {
    static const Encoding<std::uint8_t> encoding = make_srgb_encoding();
    return encoding;
}

}  // namespace

double film_width_in_pixels(const AlbedoOptions& options,
                            const RasterGrid& grid,
                            const Torus& torus) {
    if (options.film_unit == WidthUnit::Pixels) {
        return options.film_width;
    }
    const double diameter = 2.0 * std::numbers::inv_sqrtpi;  // of a circle of area 1
    return options.film_width * diameter * pixels_per_unit(grid, torus);
}

void write_albedo(const Frame& frame,
                  const CellOutlines& cells,
                  const AlbedoOptions& options,
                  int threads,
                  ImageView<std::uint8_t> image) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument("the low end of the pressures must lie below the high end");
    }
    fill_cells(cells, cell_values(frame, options), srgb_encoding(), threads, image);
}

Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads) {
    const double width = film_width_in_pixels(options, grid, frame.torus);
    const CellOutlines cells = outline_cells(frame, grid, width, threads);
    Image<std::uint8_t> image(grid.width, grid.height, 3);
    write_albedo(frame, cells, options, threads, image.view());
    return image;
}

}  // namespace foam::texgen
