// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/cell_fill.h"

#include "core/foam/measure.h"
#include "texgen/raster/coverage/fill.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

constexpr std::uint16_t kFullValue = 65535;

// The value of a bubble or of the films, in up to kMaxChannels channels.
using Texel = std::array<std::uint16_t, kMaxChannels>;

// Returns the values of all bubbles, and of the surroundings of a patch, in the order of
// CellValues. texel_of(k) returns the value of bubble k. Bubbles are numbered in the order of
// PerBubble, and `count` is the number of bubbles. Only the first `channels` channels of a value
// are used. In a patch, the surroundings come after the bubbles of the network and before the lone
// bubbles, and have the value 0.
template <class TexelOf>
CellValues cell_values(const FrameLayers& layers,
                       std::size_t channels,
                       std::size_t count,
                       const TexelOf& texel_of) {
    CellValues values{channels, {}, {}};
    const auto append = [&](const Texel& texel) {
        values.bubbles.insert(values.bubbles.end(),
                              texel.begin(),
                              texel.begin() + static_cast<std::ptrdiff_t>(channels));
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (layers.is_patch() && k == layers.frame().bubbles.size()) {
            append({});
        }
        append(texel_of(k));
    }
    if (layers.is_patch() && count == layers.frame().bubbles.size()) {
        append({});
    }
    return values;
}

Texel light_of(const LinearRgb& color) {
    return {to_sample(color.r), to_sample(color.g), to_sample(color.b), kFullValue};
}

// A linear scale from the smallest number in a CellNumbers to the largest one, divided into 65535
// equal steps. The class converts numbers to counts of steps from the start of the scale, and back.
// The counts are the 16-bit values that the rasterizer averages.
class Steps {
  public:
    explicit Steps(const CellNumbers& numbers) {
        const auto [low, high] =
            std::minmax_element(numbers.bubbles.begin(), numbers.bubbles.end());
        const bool any = low != numbers.bubbles.end();
        low_ = any ? std::min(*low, numbers.film) : numbers.film;
        range_ = (any ? std::max(*high, numbers.film) : numbers.film) - low_;
    }
    std::uint16_t step(double number) const {
        return range_ > 0.0 ? to_sample((number - low_) / range_) : std::uint16_t{0};
    }
    float number(std::uint16_t step) const {
        return static_cast<float>(low_ + range_ * (step / kWhite));
    }

  private:
    double low_ = 0.0;
    double range_ = 0.0;
};

Image<float> numbers_of(const Image<std::uint16_t>& steps, const Steps& scale) {
    Image<float> image(steps.width(), steps.height(), 1);
    std::transform(steps.samples().begin(),
                   steps.samples().end(),
                   image.samples().begin(),
                   [&](std::uint16_t step) { return scale.number(step); });
    return image;
}

// Converts the image of a patch to numbers. The second channel of `steps` is the opacity; pixels
// with an opacity of 0 become 0.
Image<float> covered_numbers_of(const Image<std::uint16_t>& steps, const Steps& scale) {
    Image<float> image(steps.width(), steps.height(), 1);
    const std::span<const std::uint16_t> from = steps.samples();
    const std::span<float> to = image.samples();
    for (std::size_t k = 0; k < to.size(); ++k) {
        to[k] = from[2 * k + 1] > 0 ? scale.number(from[2 * k]) : 0.0F;
    }
    return image;
}

// In a cross-fade, paints the border between the regions of the two foams as a film over an image
// of bubbles and films. Paints nothing if the frame shows only one foam or films have no width.
void paint_border(FrameLayers& layers,
                  double film_width,
                  const Texel& film,
                  Image<std::uint16_t>& image) {
    const FadeBorder* const border = film_width > 0.0 ? layers.border() : nullptr;
    if (border == nullptr) {
        return;
    }
    const auto channels = static_cast<std::size_t>(image.channels());
    for (std::size_t k = 0; k < border->distance.samples().size(); ++k) {
        const float part = line_coverage(border->distance.samples()[k], film_width);
        for (std::size_t c = 0; part > 0.0F && c < channels; ++c) {
            std::uint16_t& sample = image.samples()[channels * k + c];
            sample = static_cast<std::uint16_t>(std::lround(
                std::lerp(static_cast<float>(sample), static_cast<float>(film[c]), part)));
        }
    }
}

}  // namespace

ColorPixels fill_colors(FrameLayers& layers,
                        const PerBubble<LinearRgb>& colors,
                        const LinearRgb& film,
                        double film_width) {
    const std::size_t channels = layers.is_patch() ? 4 : 3;
    CellValues values = cell_values(
        layers, channels, colors.size(), [&](std::size_t k) { return light_of(colors[k]); });
    values.film = light_of(film);
    const CellArcs& cells = layers.arcs(film_width);
    const RasterGrid& grid = layers.grid();
    Image<std::uint16_t> image(grid.width, grid.height, static_cast<int>(channels));
    if (layers.is_patch()) {
        fill_straight(cells, values, layers.threads(), image.view());
    } else {
        fill_cells(cells, values, layers.threads(), image.view());
        paint_border(layers, film_width, values.film, image);
    }
    return {std::move(image), {values.film[0], values.film[1], values.film[2]}};
}

Image<float> fill_numbers(FrameLayers& layers, const CellNumbers& numbers, double film_width) {
    const Steps scale(numbers);
    const std::size_t channels = layers.is_patch() ? 2 : 1;
    const auto texel_of = [&](double number) {
        return Texel{scale.step(number), kFullValue, 0, 0};
    };
    CellValues values = cell_values(layers, channels, numbers.bubbles.size(), [&](std::size_t k) {
        return texel_of(numbers.bubbles[k]);
    });
    values.film = texel_of(numbers.film);
    const CellArcs& cells = layers.arcs(film_width);
    const RasterGrid& grid = layers.grid();
    Image<std::uint16_t> steps(grid.width, grid.height, static_cast<int>(channels));
    if (layers.is_patch()) {
        fill_straight(cells, values, layers.threads(), steps.view());
        return covered_numbers_of(steps, scale);
    }
    fill_cells(cells, values, layers.threads(), steps.view());
    paint_border(layers, film_width, values.film, steps);
    return numbers_of(steps, scale);
}

Image<float> fill_numbers(FrameLayers& layers, const PerBubble<double>& bubbles) {
    // No pixel shows a film of width 0, but CellNumbers::film affects the scale (Steps). If `film`
    // is the number of a bubble, the scale depends only on the numbers of bubbles.
    const double film = bubbles.empty() ? 0.0 : bubbles.front();
    return fill_numbers(layers, {bubbles, film}, 0.0);
}

std::vector<double> radii_by_cell_id(const FrameLayers& layers, double around) {
    const Frame& frame = layers.frame();
    const double scale = pixels_per_unit(layers.grid(), frame.domain);
    const auto radii = per_bubble<double>(
        frame,
        [&](BubbleId bubble) {
            return scale * std::sqrt(frame.bubbles[bubble].area / std::numbers::pi);
        },
        [&](const LoneBubble& bubble) { return scale * lone_radius(bubble); });
    return by_cell_id(frame, radii, around);
}

IdPixels paint_ids(FrameLayers& layers, const PerBubble<std::uint32_t>& ids) {
    const std::vector<std::uint32_t> by_id = by_cell_id(layers.frame(), ids, 0U);
    IdPixels image{layers.distance().ids};
    for (std::uint32_t& id : image.pixels.samples()) {
        id = by_id[id];
    }
    return image;
}

Image<float> fill_coverage(FrameLayers& layers, Part part, double film_width) {
    const std::uint16_t cell = part == Part::Foam ? kFullValue : 0;
    const std::size_t count = layers.frame().bubbles.size() + layers.frame().lone_bubbles.size();
    CellValues values = cell_values(layers, 1, count, [&](std::size_t) {
        return Texel{cell, 0, 0, 0};
    });
    values.film.front() = kFullValue;
    const RasterGrid& grid = layers.grid();
    Image<std::uint16_t> steps(grid.width, grid.height, 1);
    fill_cells(layers.arcs(film_width), values, layers.threads(), steps.view());
    paint_border(layers, film_width, values.film, steps);
    return numbers_of(steps, Steps({{0.0, 1.0}, 0.0}));
}

}  // namespace foam::texgen
