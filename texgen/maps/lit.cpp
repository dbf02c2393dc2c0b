// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lit.h"

#include "core/geometry/elementary.h"
#include "texgen/image/bleed.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/albedo.h"
#include "texgen/maps/film_coverage.h"
#include "texgen/maps/finer_grid.h"
#include "texgen/maps/reflections.h"
#include "texgen/maps/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace foam::texgen {

namespace {

// A shaded color is the color of the map times the diffuse light, plus a highlight and a rim light.
// Diffuse light is a mix of direct light (Lambert's cosine law) and the visible fraction of the
// sky. The highlight depends on the halfway vector (J. F. Blinn, "Models of light reflection for
// computer synthesized pictures", 1977). The rim light grows with the slope. The surface also
// reflects windows and the sky at the horizon like a mirror; their brightness is a function of the
// reflected direction (J. F. Blinn and M. E. Newell, "Texture and reflection in computer generated
// images", 1976). Direct light is divided by its value on flat ground, and the highlight and the
// reflection of flat ground are subtracted, so that flat ground keeps its color if the whole sky is
// visible from it. Films, the shade beside them, and the walls of a maze can glow: the fraction
// LitOptions::glow of their color is not shaded. The picture is drawn on a finer grid, whose pixels
// are called samples, and squares of samples are averaged.

// Returns the options for the finer grid: if the film width is in pixels, it is multiplied by
// `samples`.
AlbedoOptions finer(AlbedoOptions options, int samples) {
    if (options.film_unit == WidthUnit::Pixels) {
        options.film_width *= samples;
    }
    return options;
}

// Computes the shaded colors of points of a relief.
class Lighting {
  public:
    explicit Lighting(const LitOptions& options)
        : options_(options),
          light_(direction_of(options.azimuth, options.elevation)),
          halfway_((light_ + Direction::UnitZ()).normalized()),
          flat_highlight_(ieee::pow(halfway_.z(), options.shininess)),
          reflections_(options.reflections, options.azimuth, options.elevation) {}

    // Returns the shaded color of a point. `slope` is the gradient of the height at the point.
    // `sky` is the fraction of the sky that is visible from the point. `glowing` is the fraction of
    // the color that is emitted light.
    LinearRgb lit(const LinearRgb& color, const Vec2& slope, double sky, double glowing) const {
        const Direction normal = Direction(-slope.x(), -slope.y(), 1.0).normalized();
        const double direct = std::max(normal.dot(light_), 0.0) / light_.z();
        const double diffuse = std::lerp(direct, sky, options_.ambient);
        const double steep = 1.0 - normal.z();
        double shine = options_.gloss * highlight(normal) + options_.rim * steep * steep * steep;
        if (!reflections_.are_none()) {
            shine += reflections_.brightness(normal);
        }
        const double factor = std::lerp(diffuse, 1.0, glowing);
        const double added = (1.0 - glowing) * shine;
        const auto one = [&](double part) { return std::clamp(factor * part + added, 0.0, 1.0); };
        return {one(color.r), one(color.g), one(color.b)};
    }

  private:
    // Returns the brightness of the highlight minus the brightness of the highlight of flat ground,
    // but at least 0.
    double highlight(const Direction& normal) const {
        const double cosine = normal.dot(halfway_);
        return cosine > halfway_.z()
                   ? std::max(ieee::pow(cosine, options_.shininess) - flat_highlight_, 0.0)
                   : 0.0;
    }

    const LitOptions& options_;
    Direction light_;
    Direction halfway_;
    double flat_highlight_;  // the highlight of flat ground
    Reflections reflections_;
};

// Returns the fraction of every pixel's color that is emitted light.
Image<float> glow_of(FrameLayers& layers, const LitOptions& lit, const LitSurface& surface) {
    const AlbedoOptions& albedo = surface.albedo;
    const bool is_maze = lit.colors == LitColors::Maze;
    Image<float> shining =
        is_maze ? maze_wall_coverage(layers, surface.relief.maze) : film_coverage(layers, albedo);
    const Image<float> shade =
        albedo.shade > 0.0 && !is_maze ? film_shade(layers, albedo) : shining;
    std::transform(shining.samples().begin(),
                   shining.samples().end(),
                   shade.samples().begin(),
                   shining.samples().begin(),
                   [&](float film, float beside) {
                       return static_cast<float>(lit.glow) * std::max(film, beside);
                   });
    return shining;
}

// Draws the colors without light.
ColorPixels draw_colors(FrameLayers& layers, LitColors colors, const LitSurface& surface) {
    switch (colors) {
        case LitColors::Albedo:
            return draw_albedo(layers, surface.albedo);
        case LitColors::ThinFilm:
            return draw_thin_film(layers, surface.thin_film, surface.albedo);
        case LitColors::Maze:
            return draw_maze(layers, surface.relief.maze);
    }
    return {};
}

// Draws the shaded colors, one sample per pixel of the layers.
ColorPixels draw_samples(FrameLayers& layers, const LitOptions& lit, const LitSurface& surface) {
    ColorPixels colors = draw_colors(layers, lit.colors, surface);
    const Relief relief(layers, surface.relief, ReliefSection::kSkyReach);
    const Image<float> sky = occlusion_of(relief, layers.grid(), surface.occlusion);
    const Image<float> glow = lit.glow > 0.0 ? glow_of(layers, lit, surface) : Image<float>();
    const Lighting lighting(lit);
    const std::span<std::uint16_t> samples = colors.pixels.samples();
    const auto channels = static_cast<std::size_t>(colors.pixels.channels());
    for (std::size_t k = 0; k < sky.samples().size(); ++k) {
        const auto pixel = samples.subspan(channels * k, 3);
        const LinearRgb shown =
            lighting.lit({pixel[0] / kWhite, pixel[1] / kWhite, pixel[2] / kWhite},
                         relief.slope(k),
                         static_cast<double>(sky.samples()[k]),
                         glow.samples().empty() ? 0.0 : static_cast<double>(glow.samples()[k]));
        pixel[0] = to_sample(shown.r);
        pixel[1] = to_sample(shown.g);
        pixel[2] = to_sample(shown.b);
    }
    return colors;
}

// Averages squares of samples. If the image has a fourth channel, the opacity, colors are weighted
// by the opacity.
class Means {
  public:
    Means(const Image<std::uint16_t>& fine, int samples) : fine_(fine), samples_(samples) {}

    // Writes the mean of the samples of the pixel (x, y) to `pixel`.
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

Keys<LitOptions> lit_keys() {
    using Options = LitOptions;
    constexpr Choices<LitColors, 3> kColors = {{{{"albedo", LitColors::Albedo},
                                                 {"thin_film", LitColors::ThinFilm},
                                                 {"maze", LitColors::Maze}}}};
    return joined<LitOptions>(
        {{key("colors", kColors, "the map that is lit", &Options::colors),
          key("azimuth",
              Reals{-360.0, 360.0},
              "direction of the light: degrees counterclockwise from the right",
              &Options::azimuth)
              .in("degrees"),
          key("elevation",
              Reals{1.0, 90.0},
              "angle of the light above the ground, degrees; does not change the color of flat "
              "ground",
              &Options::elevation)
              .in("degrees"),
          key("ambient",
              kFractions,
              "fraction of the diffuse light that comes from the sky",
              &Options::ambient)
              .in("fraction of the diffuse light"),
          key("gloss", Reals{0.0, 1000.0}, "brightness of highlights", &Options::gloss),
          key("shininess",
              Reals{1.0, 10000.0},
              "exponent of highlights; larger values make them smaller",
              &Options::shininess)
              .unused_with("lit.gloss", {"0.0"}),
          key("rim",
              Reals{0.0, 1000.0},
              "brightness added to steep slopes, such as the rims of bubbles",
              &Options::rim),
          key("glow",
              kFractions,
              "fraction of the color of films, of the shade beside films, and of the walls of a "
              "maze that is emitted light and therefore not shaded",
              &Options::glow)
              .in("fraction of the color"),
          key("samples", Integers{1, 8}, "samples per pixel in each direction", &Options::samples)
              .in("samples per pixel, in each direction")},
         nested_keys("", &Options::reflections, reflection_keys())});
}

ColorPixels draw_lit(FrameLayers& layers, const LitOptions& options, const LitSurface& surface) {
    const int samples = samples_for(layers.grid(), options.samples);
    const AlbedoOptions fine_albedo = finer(surface.albedo, samples);
    FrameLayers fine = layers.on_grid(finer(layers.grid(), samples), {.smooth = true});
    const ColorPixels drawn = draw_samples(
        fine, options, {fine_albedo, surface.thin_film, surface.relief, surface.occlusion});
    const int channels = drawn.pixels.channels();
    Image<std::uint16_t> image(layers.grid().width, layers.grid().height, channels);
    const Means means(drawn.pixels, samples);
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            means.write(x, y, image.pixel(x, y));
        }
    }
    if (layers.is_patch()) {
        const LinearRgb film = to_linear(parse_color(surface.albedo.film_color));
        bleed_colors(image.view(), {to_sample(film.r), to_sample(film.g), to_sample(film.b)});
    }
    return {std::move(image)};
}

}  // namespace foam::texgen
