// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/caustics.h"

#include "core/geometry/elementary.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/color_scale.h"
#include "texgen/maps/finer_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

// Rays of light start at the pixels of a finer grid and move to the floor. Each ray lights a square
// of one pixel on the floor. The pixels that the square overlaps share the ray in proportion to the
// overlap. Positions on the floor are integers, and light is summed in integers. Therefore, a shift
// of the grid by whole pixels shifts the image exactly.

constexpr double kIndexOfWater = 1.33;  // refractive index
// Positions on the floor are in units of 1 / kUnit of a pixel. Let n be the number of rays per
// pixel in each direction, from 1 to 8. kUnit is a multiple of 2 n for each of these n, so rays
// start at whole units.
constexpr std::int64_t kUnit = 1680;
constexpr double kFarthest = 16384.0;  // largest motion of a ray in x or y, pixels

// The light that has reached every pixel of the floor, in units of 1 / kUnit² of a ray.
class Floor {
  public:
    Floor(const RasterGrid& grid, const Domain& domain)
        : light_(grid.width, grid.height, 1),
          wraps_(!domain.is_plane()),
          shear_(wraps_ ? shear_in_subpixels(grid, domain) * kUnit / kSubpixel : 0) {}

    // Adds a ray. It lights a square of the size of a pixel, whose lower left corner is at (x, y).
    void add(std::int64_t x, std::int64_t y) {
        const std::int64_t row = floor_divide(y, kUnit);
        const std::int64_t above = y - row * kUnit;
        add_row(x, row, kUnit - above);
        add_row(x, row + 1, above);
    }

    const Image<std::uint64_t>& light() const { return light_; }

  private:
    static std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
        return a >= 0 ? a / b : -((b - 1 - a) / b);
    }

    // Adds the part of a ray that falls on one row. On a torus, a row beyond the upper or lower
    // border belongs to the next copy of the torus, which is displaced by the shear.
    void add_row(std::int64_t x, std::int64_t row, std::int64_t part) {
        const std::int64_t copy = floor_divide(row, light_.height());
        if (part == 0 || (copy != 0 && !wraps_)) {
            return;
        }
        const std::int64_t left = x - copy * shear_;
        const std::int64_t column = floor_divide(left, kUnit);
        const std::int64_t right_part = left - column * kUnit;
        const auto y = static_cast<int>(row - copy * light_.height());
        add_pixel(column, y, (kUnit - right_part) * part);
        add_pixel(column + 1, y, right_part * part);
    }

    void add_pixel(std::int64_t column, int y, std::int64_t light) {
        const std::int64_t copy = floor_divide(column, light_.width());
        if (copy == 0 || wraps_) {
            const auto x = static_cast<int>(column - copy * light_.width());
            light_.pixel(x, y)[0] += static_cast<std::uint64_t>(light);
        }
    }

    Image<std::uint64_t> light_;
    bool wraps_;
    std::int64_t shear_;  // in units of 1 / kUnit of a pixel
};

// Returns the light on the floor. `samples` is the number of rays per pixel in each direction.
Floor light_floor(FrameLayers& layers, const ReliefSource& source, double depth, int samples) {
    FrameLayers rays =
        layers.on_grid(finer(layers.grid(), samples),
                       {.distance = false, .smooth = SmoothImages::DistanceAndGradient});
    const Relief relief(rays, source, Relief::kFoot);
    const double diameter = relief.diameter() / samples;  // in pixels of the floor
    const double reach =
        depth * diameter * (1.0 - 1.0 / kIndexOfWater) * static_cast<double>(kUnit);
    const double farthest = kFarthest * static_cast<double>(kUnit);
    const PixelSlopes slopes = relief.slopes();
    Floor floor(layers.grid(), layers.frame().domain);
    const int width = rays.grid().width;
    const int height = rays.grid().height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(x);
            const Vec2 slope(slopes.x.samples()[index], slopes.y.samples()[index]);
            const Vec2 motion = (reach * slope).cwiseMin(farthest).cwiseMax(-farthest);
            // Before the motion, the middle of the square is at ((x + 1/2) / samples,
            // (y + 1/2) / samples). Its lower left corner is half a pixel further left and lower.
            const auto start = [samples](std::int64_t ray) {
                return (2 * ray + 1 - samples) * (kUnit / (std::int64_t{2} * samples));
            };
            floor.add(start(x) + std::llround(motion.x()), start(y) + std::llround(motion.y()));
        }
    }
    return floor;
}

}  // namespace

Keys<CausticsOptions> caustics_keys() {
    using Options = CausticsOptions;
    return {key("depth",
                Reals{0.0, 100.0},
                "depth of the water, in bubble diameters; deeper water spreads the light farther",
                &Options::depth)
                .in(kReliefDiameters),
            key("exposure",
                Reals{0.0, 100.0},
                "brightness of the light: a floor under flat water has the brightness "
                "1 - exp(-exposure)",
                &Options::exposure),
            key("colors",
                ColorLists{},
                "colors of the floor, from no light to the brightest light",
                &Options::colors),
            key("samples", Integers{1, 8}, "rays per pixel in each direction", &Options::samples)
                .in("rays per pixel, in each direction")};
}

ColorPixels draw_caustics(FrameLayers& layers,
                          const ReliefSource& source,
                          const CausticsOptions& options) {
    const int samples = samples_for(layers.grid(), options.samples);
    const std::vector<LinearRgb> colors =
        parse_colors(options.colors.empty() ? CausticsOptions{}.colors : options.colors);
    const Floor floor = light_floor(layers, source, options.depth, samples);
    const bool is_patch = layers.is_patch();
    const Image<float> opacity = is_patch ? fill_coverage(layers, Part::Foam, 0.0) : Image<float>();
    Image<std::uint16_t> image(
        layers.grid().width, layers.grid().height, is_patch ? kChannelsWithOpacity : 3);
    const double unit = static_cast<double>(kUnit * kUnit) * samples * samples;
    const std::span<const std::uint64_t> light = floor.light().samples();
    const auto channels = static_cast<std::size_t>(image.channels());
    for (std::size_t k = 0; k < light.size(); ++k) {
        const double brightness =
            1.0 - ieee::exp(-options.exposure * static_cast<double>(light[k]) / unit);
        write_pixel(blended(colors, brightness),
                    is_patch ? static_cast<double>(opacity.samples()[k]) : 1.0,
                    image.samples().subspan(channels * k, channels));
    }
    const LinearRgb& dark = colors.front();
    return {std::move(image), {to_sample(dark.r), to_sample(dark.g), to_sample(dark.b)}};
}

}  // namespace foam::texgen
