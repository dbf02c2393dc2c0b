#include "texgen/maps/lit.h"

#include "texgen/image/bleed.h"
#include "texgen/maps/film_look.h"
#include "texgen/maps/map_options.h"
#include "texgen/maps/relief.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr int kRimPower = 3;

using Direction = Eigen::Vector3d;  // right, up, towards the eye

// Fewer samples where so many would be more pixels than a grid may have.
int samples_for(const RasterGrid& grid, int wanted) {
    return std::clamp(kLargestSide / std::max(grid.width, grid.height), 1, wanted);
}

RasterGrid finer(RasterGrid grid, int samples) {
    grid.width *= samples;
    grid.height *= samples;
    grid.shift_x *= samples;
    grid.shift_y *= samples;
    if (grid.view) {
        grid.view->pixels_per_unit *= samples;
    }
    return grid;
}

// What is measured in pixels is so in those of the finer grid.
MapOptions finer(MapOptions options, int samples) {
    if (options.albedo.film_unit == WidthUnit::Pixels) {
        options.albedo.film_width *= samples;
    }
    return options;
}

// Light on a relief.
class Lighting {
  public:
    explicit Lighting(const LitOptions& options)
        : options_(options),
          light_(std::cos(options.elevation * kDegree) * std::cos(options.azimuth * kDegree),
                 std::cos(options.elevation * kDegree) * std::sin(options.azimuth * kDegree),
                 std::sin(options.elevation * kDegree)),
          halfway_((light_ + Direction::UnitZ()).normalized()),
          flat_highlight_(highlight(Direction::UnitZ())) {}

    // Of a place that sees a part of the sky and shines by itself with a part of its colour.
    LinearRgb lit(const LinearRgb& color, const Vec2& slope, double sky, double glowing) const {
        const Direction normal = Direction(-slope.x(), -slope.y(), 1.0).normalized();
        const double direct = std::max(normal.dot(light_), 0.0) / light_.z();
        const double diffuse = std::lerp(direct, sky, options_.ambient);
        const double shine = options_.gloss * std::max(highlight(normal) - flat_highlight_, 0.0) +
                             options_.rim * std::pow(1.0 - normal.z(), kRimPower);
        const double factor = std::lerp(diffuse, 1.0, glowing);
        const double added = (1.0 - glowing) * shine;
        const auto one = [&](double part) { return std::clamp(factor * part + added, 0.0, 1.0); };
        return {one(color.r), one(color.g), one(color.b)};
    }

  private:
    double highlight(const Direction& normal) const {
        return std::pow(std::max(normal.dot(halfway_), 0.0), options_.shininess);
    }

    const LitOptions& options_;
    Direction light_;
    Direction halfway_;
    double flat_highlight_;  // taken off everywhere
};

// The part of every pixel that shines by itself.
Image<float> glow_of(FrameLayers& layers, const AlbedoOptions& albedo, double glow) {
    Image<float> shining = film_cover(layers, albedo);
    const Image<float> shade = albedo.shade > 0.0 ? film_shade(layers, albedo) : shining;
    std::transform(shining.samples().begin(),
                   shining.samples().end(),
                   shade.samples().begin(),
                   shining.samples().begin(),
                   [&](float film, float beside) {
                       return static_cast<float>(glow) * std::max(film, beside);
                   });
    return shining;
}

ColorPixels draw_samples(FrameLayers& layers, const MapOptions& options) {
    const LitOptions& lit = options.lit;
    ColorPixels colors = lit.colors == LitColors::Albedo
                             ? draw_albedo(layers, options.albedo)
                             : draw_thin_film(layers, options.thin_film, options.albedo);
    const Relief relief(layers, options.relief);
    const NumberPixels sky = draw_occlusion(layers, options.relief, options.occlusion);
    const Image<float> glow =
        lit.glow > 0.0 ? glow_of(layers, options.albedo, lit.glow) : Image<float>();
    const Lighting lighting(lit);
    const std::span<std::uint16_t> samples = colors.pixels.samples();
    const auto channels = static_cast<std::size_t>(colors.pixels.channels());
    for (std::size_t k = 0; k < sky.pixels.samples().size(); ++k) {
        const auto pixel = samples.subspan(channels * k, 3);
        const LinearRgb shown =
            lighting.lit({pixel[0] / kWhite, pixel[1] / kWhite, pixel[2] / kWhite},
                         relief.slope(k),
                         static_cast<double>(sky.pixels.samples()[k]),
                         glow.samples().empty() ? 0.0 : static_cast<double>(glow.samples()[k]));
        pixel[0] = light_step(shown.r);
        pixel[1] = light_step(shown.g);
        pixel[2] = light_step(shown.b);
    }
    return colors;
}

// Means of squares of pixels; colours of four channels are weighted by the last.
class Means {
  public:
    Means(const Image<std::uint16_t>& fine, int samples) : fine_(fine), samples_(samples) {}

    void write(int x, int y, std::span<std::uint16_t> pixel) const {
        std::array<std::uint64_t, 4> sums{};
        std::uint64_t weights = 0;
        for (int k = 0; k < samples_ * samples_; ++k) {
            const auto one = fine_.pixel(x * samples_ + k % samples_, y * samples_ + k / samples_);
            const std::uint64_t weight = one.size() > 3 ? one[3] : 1;
            for (std::size_t c = 0; c < 3; ++c) {
                sums[c] += weight * one[c];
            }
            weights += weight;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            pixel[c] = rounded(sums[c], weights);
        }
        if (pixel.size() > 3) {
            const auto side = static_cast<std::uint64_t>(samples_);
            pixel[3] = rounded(weights, side * side);
        }
    }

  private:
    static std::uint16_t rounded(std::uint64_t sum, std::uint64_t count) {
        return static_cast<std::uint16_t>(count > 0 ? (sum + count / 2) / count : 0);
    }

    const Image<std::uint16_t>& fine_;
    int samples_;
};

}  // namespace

ColorPixels draw_lit(FrameLayers& layers, const MapOptions& options) {
    const int samples = samples_for(layers.grid(), options.lit.samples);
    FrameLayers fine({layers.frame(), layers.record(), nullptr, {.smooth = true}},
                     finer(layers.grid(), samples),
                     layers.threads());
    const ColorPixels drawn = draw_samples(fine, finer(options, samples));
    const int channels = drawn.pixels.channels();
    Image<std::uint16_t> image(layers.grid().width, layers.grid().height, channels);
    const Means means(drawn.pixels, samples);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            means.write(x, y, image.pixel(x, y));
        }
    }
    if (layers.is_patch()) {
        const LinearRgb film = to_linear(parse_color(options.albedo.film_color));
        bleed_colors(image.view(), {light_step(film.r), light_step(film.g), light_step(film.b)});
    }
    return {std::move(image)};
}

}  // namespace foam::texgen
