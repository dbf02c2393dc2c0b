#include "texgen/maps/albedo.h"

#include "core/foam/measure.h"
#include "core/foam/statistics.h"
#include "texgen/image/bleed.h"
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
constexpr std::uint16_t kOpaque = 65535;

// Length of the film tension over the unit of pressure.
double pressure_unit_length(const Frame& frame, PressureUnit unit) {
    return unit == PressureUnit::Seed ? 1.0 : std::sqrt(mean_area(frame));
}

using Light = std::array<std::uint16_t, 3>;

Light light(const LinearRgb& color) {
    const auto value = [](double x) {
        return static_cast<std::uint16_t>(std::lround(x * kLargestValue));
    };
    return {value(color.r), value(color.g), value(color.b)};
}

Light film_light(const AlbedoOptions& options) {
    return light(to_linear(parse_color(options.film_color)));
}

// Of every bubble; of a patch then that of the ghost and those of lone bubbles.
std::vector<double> pressures(const Frame& frame) {
    std::vector<double> all;
    for (const FrameBubble& bubble : frame.bubbles) {
        all.push_back(bubble.pressure);
    }
    if (frame.torus.is_plane()) {
        all.push_back(0.0);
    }
    for (const LoneBubble& bubble : frame.lone_bubbles) {
        all.push_back(frame.film_tension / lone_radius(bubble));
    }
    return all;
}

// Three channels of light and, in a patch, one of opacity, which only what is around it has none
// of.
CellValues cell_values(const Frame& frame, const AlbedoOptions& options) {
    const ColorMap& colormap = find_colormap(options.colormap);
    const double unit = pressure_unit_length(frame, options.pressure_unit) / frame.film_tension;
    const double range = options.pressure_high - options.pressure_low;
    const auto channels = static_cast<std::size_t>(albedo_channels(frame));
    CellValues values{channels, {}, {}};
    for (const double pressure : pressures(frame)) {
        const double t = (pressure * unit - options.pressure_low) / range;
        const Light color = light(colormap.at(t));
        values.cells.insert(values.cells.end(), color.begin(), color.end());
        values.cells.resize(values.cells.size() + channels - color.size(), kOpaque);
    }
    const Light film = film_light(options);
    std::copy(film.begin(), film.end(), values.film.begin());
    values.film.back() = kOpaque;
    if (frame.torus.is_plane()) {
        std::fill_n(&values.cells[channels * frame.bubbles.size()], channels, std::uint16_t{0});
    }
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

// Light as sRGB, opacity as it is, to the nearest of 256 steps.
void encode_straight(ImageView<const std::uint16_t> from, ImageView<std::uint8_t> to) {
    constexpr std::size_t kChannels = 4;
    const Encoding<std::uint8_t>& encoding = srgb_encoding();
    for (int y = 0; y < from.height(); ++y) {
        const auto row = from.row(y);
        const auto encoded = to.row(y);
        for (std::size_t k = 0; k < row.size(); k += kChannels) {
            for (std::size_t c = 0; c + 1 < kChannels; ++c) {
                encoded[k + c] = encoding[row[k + c]];
            }
            const std::uint32_t opacity = row[k + kChannels - 1];
            encoded[k + kChannels - 1] = static_cast<std::uint8_t>((opacity + 128) / 257);
        }
    }
}

}  // namespace

int albedo_channels(const Frame& frame) {
    return frame.torus.is_plane() ? 4 : 3;
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

void write_albedo(const Frame& frame,
                  const CellOutlines& cells,
                  const AlbedoOptions& options,
                  int threads,
                  ImageView<std::uint8_t> image) {
    if (!(options.pressure_low < options.pressure_high)) {
        throw std::invalid_argument("the low end of the pressures must lie below the high end");
    }
    const CellValues values = cell_values(frame, options);
    if (!frame.torus.is_plane()) {
        fill_cells(cells, values, srgb_encoding(), threads, image);
        return;
    }
    Image<std::uint16_t> straight(image.width(), image.height(), image.channels());
    fill_straight(cells, values, threads, straight.view());
    bleed_colors(straight.view(), film_light(options));
    encode_straight(straight.view(), image);
}

Image<std::uint8_t> albedo(const Frame& frame,
                           const RasterGrid& grid,
                           const AlbedoOptions& options,
                           int threads) {
    const double width = film_width_in_pixels(options, grid, frame.torus);
    const CellOutlines cells = outline_cells(frame, grid, width, threads);
    Image<std::uint8_t> image(grid.width, grid.height, albedo_channels(frame));
    write_albedo(frame, cells, options, threads, image.view());
    return image;
}

}  // namespace foam::texgen
