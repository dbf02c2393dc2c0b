// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lit.h"

#include "core/parallel/simd_level.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/color_loops.h"
#include "texgen/maps/lighting.h"
#include "texgen/maps/pixel_contrast.h"
#include "texgen/maps/pixel_neighbors.h"
#include "texgen/maps/relief.h"
#include "texgen/maps/relief_sampler.h"
#include "texgen/raster/simd/kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// The map `lit` shades the colors of another map (LitOptions::colors), called the source map here.
// A shaded color is the color of the source map times the diffuse light, plus the shine
// (lighting.h). Films, the tinted zones beside films (AlbedoOptions::shade), and the walls of a
// maze can glow: the fraction LitOptions::glow of their color is not shaded. The color of the
// source map is already the mean over the pixel. The light is computed at the center of each pixel.
// One point is not enough at creases, in small highlights and at the borders of reflected windows.
// There, the shaded color is the mean over several points of the pixel. This is done in the pixels
// that a film or wall may cross, and in pixels of high contrast (pixel_contrast.h; D. P. Mitchell,
// "Generating antialiased images at low sampling densities", 1987). The relief at the points of
// these pixels is computed from the smooth distance around the center (relief_sampler.h).

// The light at points (PointLights). The vectors have one number per point.
struct Light {
    explicit Light(std::size_t count) : diffuse(count), shine(count) {}

    std::vector<float> diffuse;
    std::vector<float> shine;
};

// Returns one component of a shaded color, from 0 to kWhite. `color` is this component before
// shading.
float shaded(float color, float diffuse, float shine) {
    constexpr auto kMaxSample = static_cast<float>(kWhite);
    return min_value(max_value(diffuse * color + shine * kMaxSample, 0.0F), kMaxSample);
}

// Replaces the fraction `glow` of the light at each point by emitted light.
void add_glow(std::span<const float> glow, Light& light) {
    at_simd_level([count = glow.size(),
                   parts = glow.data(),
                   diffuse = light.diffuse.data(),
                   shine = light.shine.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            diffuse[k] += parts[k] * (1.0F - diffuse[k]);
            shine[k] *= 1.0F - parts[k];
        }
    });
}

// The surface at the centers of pixels, and the unlit mean color of each pixel.
struct Surface {
    PixelSlopes slopes;
    Image<float> sky;   // the visible fraction of the sky
    Image<float> glow;  // the fraction of the color that is emitted light; empty if it is 0
    Image<std::uint16_t> colors;
};

Light light_at_centers(const Surface& surface, const Lighting& lighting) {
    Light light(surface.sky.samples().size());
    lighting.shade({surface.slopes.x.samples(), surface.slopes.y.samples(), surface.sky.samples()},
                   {light.diffuse, light.shine});
    if (!surface.glow.samples().empty()) {
        add_glow(surface.glow.samples(), light);
    }
    return light;
}

// Returns the largest component of the shaded color of each pixel, or NaN if the pixel has no
// opacity. Comparisons with NaN are false, so find_contrasts ignores the edge of a patch.
std::vector<float> brightness_of(const Image<std::uint16_t>& colors, const Light& light) {
    constexpr float kClear = std::numeric_limits<float>::quiet_NaN();
    std::vector<float> brightness(light.shine.size());
    at_simd_level([count = brightness.size(),
                   to = brightness.data(),
                   channels = static_cast<std::size_t>(colors.channels()),
                   color = colors.samples().data(),
                   diffuse = light.diffuse.data(),
                   shine = light.shine.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            const std::uint16_t* const rgb = color + channels * k;
            const auto largest = static_cast<float>(max_value(max_value(rgb[0], rgb[1]), rgb[2]));
            const float value = shaded(largest, diffuse[k], shine[k]);
            to[k] = rgb[channels - 1] == 0 && channels == kChannelsWithOpacity ? kClear : value;
        }
    });
    return brightness;
}

using Color = std::array<float, 3>;  // from 0 to kWhite

// Returns the values of an image of one channel at some pixels.
std::vector<float> values_at(const Image<float>& image, std::span<const std::uint32_t> pixels) {
    std::vector<float> values;
    values.reserve(pixels.size());
    for (const std::uint32_t pixel : pixels) {
        values.push_back(image.samples()[pixel]);
    }
    return values;
}

// One component of the colors of some pixels.
using Component = std::vector<float>;

// Returns a component of the color of some pixels.
Component component_at(const Image<std::uint16_t>& colors,
                       std::size_t c,
                       std::span<const std::uint32_t> pixels) {
    const auto channels = static_cast<std::size_t>(colors.channels());
    Component component;
    component.reserve(pixels.size());
    for (const std::uint32_t pixel : pixels) {
        component.push_back(static_cast<float>(colors.samples()[channels * pixel + c]));
    }
    return component;
}

// Adds a component of the shaded color at one point of each pixel to `sums`.
void add_shaded(const Component& component, const Light& light, Component& sums) {
    at_simd_level([count = component.size(),
                   to = sums.data(),
                   color = component.data(),
                   diffuse = light.diffuse.data(),
                   shine = light.shine.data()] {
        for (std::size_t k = 0; k < count; ++k) {
            to[k] += shaded(color[k], diffuse[k], shine[k]);
        }
    });
}

using ColorSamples = std::array<std::uint16_t, 3>;  // samples of ColorPixels

// Appends the shaded colors of pixels to `means`. Each color is the mean over samples² points of
// the pixel.
void add_mean_colors(std::span<const std::uint32_t> pixels,
                     const Surface& surface,
                     const Lighting& lighting,
                     int samples,
                     ReliefSampler& sampler,
                     std::vector<ColorSamples>& means) {
    sampler.choose(pixels);
    const std::vector<float> glow =
        surface.glow.samples().empty() ? std::vector<float>() : values_at(surface.glow, pixels);
    std::vector<float> x(pixels.size());
    std::vector<float> y(pixels.size());
    std::vector<float> sky(pixels.size());
    Light light(pixels.size());
    std::array<Component, 3> components;
    std::array<Component, 3> sums;
    for (std::size_t c = 0; c < 3; ++c) {
        components[c] = component_at(surface.colors, c, pixels);
        sums[c].resize(pixels.size());
    }
    const auto position = [samples](int k) { return (k + 0.5) / samples - 0.5; };
    for (int k = 0; k < samples * samples; ++k) {
        sampler.write({position(k % samples), position(k / samples)}, {x, y, sky});
        lighting.shade({x, y, sky}, {light.diffuse, light.shine});
        add_glow(glow, light);
        for (std::size_t c = 0; c < 3; ++c) {
            add_shaded(components[c], light, sums[c]);
        }
    }
    const auto mean = [points = static_cast<float>(samples * samples)](float sum) {
        return nearest_sample(sum / points);
    };
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        means.push_back({mean(sums[0][k]), mean(sums[1][k]), mean(sums[2][k])});
    }
}

// Replaces the colors of all pixels by the shaded colors at their centers.
void shade_centers(const Light& light, Image<std::uint16_t>& colors) {
    change_colors(colors,
                  [diffuse = light.diffuse.data(), shine = light.shine.data()](const Color& color,
                                                                               std::size_t k) {
                      return Color{shaded(color[0], diffuse[k], shine[k]),
                                   shaded(color[1], diffuse[k], shine[k]),
                                   shaded(color[2], diffuse[k], shine[k])};
                  });
}

void write_colors(std::span<const std::uint32_t> pixels,
                  std::span<const ColorSamples> colors,
                  Image<std::uint16_t>& image) {
    const auto channels = static_cast<std::size_t>(image.channels());
    for (std::size_t k = 0; k < pixels.size(); ++k) {
        std::ranges::copy(
            colors[k], image.samples().begin() + static_cast<std::ptrdiff_t>(channels * pixels[k]));
    }
}

// Returns the mean shaded colors of pixels, computed in batches that fit into the cache.
std::vector<ColorSamples> mean_colors(std::span<const std::uint32_t> pixels,
                                      const Surface& surface,
                                      const Lighting& lighting,
                                      int samples,
                                      ReliefSampler sampler) {
    constexpr std::size_t kBatch = 1024;
    std::vector<ColorSamples> means;
    means.reserve(pixels.size());
    for (std::size_t from = 0; from < pixels.size(); from += kBatch) {
        const auto batch = pixels.subspan(from, std::min(kBatch, pixels.size() - from));
        add_mean_colors(batch, surface, lighting, samples, sampler, means);
    }
    return means;
}

}  // namespace

Keys<LitOptions> lit_keys() {
    using Options = LitOptions;
    constexpr Choices<LitColors, 3> kColors = {{{{"albedo", LitColors::Albedo},
                                                 {"thin_film", LitColors::ThinFilm},
                                                 {"maze", LitColors::Maze}}}};
    return joined<LitOptions>(
        {{key("colors", kColors, "map whose colors are lit", &Options::colors),
          key("glow",
              kFractions,
              "emitted fraction of the color of films, of the shade beside films, and of the walls "
              "of a maze: the map `emission` shows this light, and the map `lit` does not shade it",
              &Options::glow)
              .in("fraction of the color"),
          key("samples",
              Integers{1, 8},
              "where the light varies strongly, a pixel shows the mean over several of its points; "
              "this is the number of these points in each direction",
              &Options::samples)
              .in("points per pixel, in each direction")},
         nested_keys("", &Options::light, light_keys())});
}

ColorPixels draw_lit(FrameLayers& layers, const LitOptions& options, const LitSurface& source) {
    const SurfaceColors surface_colors{
        options.colors, source.albedo, source.thin_film, source.relief.maze};
    ColorPixels colors = draw_surface_colors(layers, surface_colors);
    const std::array<std::uint16_t, 3> fallback = colors.fallback;
    Image<float> glow = options.glow > 0.0
                            ? glow_fractions(layers, surface_colors, colors, options.glow)
                            : Image<float>();
    const Relief relief(layers, source.relief, ReliefSection::kSkyReach);
    const VisibleSky sky(relief.section(), relief.strength(), source.occlusion.strength);
    Surface surface{relief.slopes(),
                    occlusion_of(relief, sky.lookup()),
                    std::move(glow),
                    std::move(colors.pixels)};
    const Lighting lighting(options.light);
    const Light light = light_at_centers(surface, lighting);
    const PixelNeighbors neighbors(layers.grid(), layers.frame().domain);
    std::vector<std::uint32_t> contrasts;
    if (options.samples > 1) {
        contrasts = find_contrasts(
            brightness_of(surface.colors, light), relief.distance().samples(), neighbors);
    }
    const std::vector<ColorSamples> means =
        mean_colors(contrasts,
                    surface,
                    lighting,
                    options.samples,
                    ReliefSampler(relief, surface.slopes, sky.lookup(), neighbors));
    shade_centers(light, surface.colors);
    write_colors(contrasts, means, surface.colors);
    return {std::move(surface.colors), fallback};
}

}  // namespace foam::texgen
