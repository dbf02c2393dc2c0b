// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/lighting.h"

#include "core/geometry/exponential.h"
#include "core/parallel/simd_level.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/table_lookup.h"
#include "texgen/raster/simd/kernel.h"

#include <cmath>
#include <cstddef>

namespace foam::texgen {

// Diffuse light is a mix of direct light (Lambert's cosine law) and the visible fraction of the
// sky. Direct light is divided by its value on flat ground. The shine is the sum of three parts:
// - a highlight, which depends on the halfway vector (J. F. Blinn, "Models of light reflection
//   for computer synthesized pictures", 1977);
// - a rim light that grows with the slope;
// - the reflections of windows and of the sky (reflections.h).
// The highlight and the reflections are each reduced by their own value on flat ground, but not
// below 0.

namespace {

constexpr int kHighlightSteps = 2048;
constexpr double kFaintest = 1e-6;  // smallest brightness of a drawn highlight, for a gloss of 1

}  // namespace

Keys<LightOptions> light_keys() {
    using Options = LightOptions;
    return joined<LightOptions>(
        {{key("azimuth",
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
              &Options::rim)},
         nested_keys("", &Options::reflections, reflection_keys())});
}

HighlightTable::HighlightTable(double gloss, double shininess, double flat)
    : first(max_value(flat, ieee::pow_of_positive(kFaintest, 1.0 / shininess))) {
    const double flat_highlight = ieee::pow_of_positive(flat, shininess);
    for (int k = 0; k <= kHighlightSteps; ++k) {
        const double cosine = first + (1.0 - first) * k / kHighlightSteps;
        const double highlight = ieee::pow_of_positive(cosine, shininess) - flat_highlight;
        brightness.push_back(gloss * max_value(highlight, 0.0));
    }
    brightness.front() = 0.0;
}

Lighting::Lighting(const LightOptions& options)
    : ambient_(options.ambient),
      rim_(options.rim),
      light_(direction_of(options.azimuth, options.elevation)),
      halfway_((light_ + Direction::UnitZ()).normalized()),
      highlights_(options.gloss, options.shininess, halfway_.z()),
      reflections_(options.reflections, options.azimuth, options.elevation) {}

// The loop uses pointers, because checked accesses to spans are not vectorized.
template <bool Reflects>
void Lighting::shade_points(const ReliefPoints<const float>& points,
                            const PointLights& lights) const {
    at_simd_level([count = points.sky.size(),
                   slopes_x = points.slopes_x.data(),
                   slopes_y = points.slopes_y.data(),
                   skies = points.sky.data(),
                   diffuse = lights.diffuse.data(),
                   shine = lights.shine.data(),
                   highlights = highlights_.brightness.data(),
                   first = highlights_.first,
                   steps_per_cosine = kHighlightSteps / max_value(1.0 - highlights_.first, 1e-15),
                   ambient = ambient_,
                   rim = rim_,
                   light = light_,
                   halfway = halfway_,
                   reflections = reflections_] {
        for (std::size_t k = 0; k < count; ++k) {
            const auto x = static_cast<double>(slopes_x[k]);
            const auto y = static_cast<double>(slopes_y[k]);
            const double scale = 1.0 / std::sqrt(1.0 + x * x + y * y);
            const Direction normal(-scale * x, -scale * y, scale);
            const double direct = max_value(normal.dot(light), 0.0) / light.z();
            const auto sky = static_cast<double>(skies[k]);
            diffuse[k] = static_cast<float>(direct + ambient * (sky - direct));
            const double step = max_value((normal.dot(halfway) - first) * steps_per_cosine, 0.0);
            const double highlight = looked_up(highlights, kHighlightSteps, step);
            const double steep = 1.0 - normal.z();
            double sum = highlight + rim * steep * steep * steep;
            if constexpr (Reflects) {
                sum += reflections.brightness(normal);
            }
            shine[k] = static_cast<float>(sum);
        }
    });
}

void Lighting::shade(const ReliefPoints<const float>& points, const PointLights& lights) const {
    if (reflections_.are_none()) {
        shade_points<false>(points, lights);
    } else {
        shade_points<true>(points, lights);
    }
}

}  // namespace foam::texgen
