// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/occlusion.h"

#include "core/geometry/elementary.h"
#include "core/parallel/simd_level.h"
#include "texgen/keys/value_kinds.h"
#include "texgen/maps/relief.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace foam::texgen {

namespace {

// The visible fraction of the sky is computed once per image for points of a ReliefSection. For
// each pixel, the fraction is looked up by the distance from the nearest film. The nearest
// film is treated as straight and endless, with the same section everywhere along it. The visible
// fraction of a uniform sky is then (sin a + sin b) / 2, where a and b are the angles from the
// normal to the horizons on both sides. The horizon on one side is the steepest line from the point
// to a sample of the section on that side, or the tangent at the point if that is steeper.

constexpr int kSteps = 128;  // samples per unit of a section
constexpr double kFar = std::numeric_limits<double>::infinity();

// A table of the visible fraction of the sky along a section. The heights of the section are
// multiplied by `strength`.
class VisibleSky {
  public:
    VisibleSky(const ReliefSection& section, double strength) {
        const int reach = static_cast<int>(section.reach() * kSteps);
        const int end = reach + kSteps;
        std::vector<double> heights;  // at the samples from -end to end
        for (int k = -end; k <= end; ++k) {
            heights.push_back(strength * section.height_along(distance_at(k)));
        }
        for (int k = 0; k <= reach; ++k) {
            sky_.push_back(visible(heights, k + end, strength * slope_at(section, distance_at(k))));
        }
    }

    // Returns the visible fraction at a distance from the film, in the section's unit. Interpolates
    // between samples.
    double at(double distance) const {
        const double last = static_cast<double>(sky_.size() - 1);
        const double step = std::min(distance * kSteps, last);
        const auto below = std::min(static_cast<std::size_t>(step), sky_.size() - 2);
        return std::lerp(sky_[below], sky_[below + 1], step - static_cast<double>(below));
    }

  private:
    // Returns the derivative of the section's height with respect to the distance x from the film.
    // The smooth distance is s = x - x²/2 for domes, and s = x for other profiles. Domes are
    // recognized by s < 1 at x = 1.
    static double slope_at(const ReliefSection& section, double distance) {
        const double smooth = section.smooth(distance);
        const double slope_of_smooth = section.smooth(1.0) < 1.0 ? 1.0 - distance : 1.0;  // ds/dx
        return section.slope(smooth) * slope_of_smooth;
    }

    static double distance_at(int step) { return static_cast<double>(step) / kSteps; }

    // Returns the visible fraction of the sky at the sample `current`, where the section has the
    // given slope.
    static double visible(std::span<const double> heights, int current, double slope) {
        // Returns the slope of the line to the horizon in the direction `step`, which is -1 or 1.
        // The slope is positive if the line rises.
        const auto steepest = [&](int step) {
            double steepness = step * slope;
            const double height = heights[static_cast<std::size_t>(current)];
            for (int k = current + step; k >= 0 && k < std::ssize(heights); k += step) {
                const double rise = heights[static_cast<std::size_t>(k)] - height;
                steepness = std::max(steepness, rise / distance_at(std::abs(k - current)));
            }
            return steepness;
        };
        constexpr double kRight = 0.5 * std::numbers::pi;
        const double tilt = ieee::atan(slope);  // tilt of the normal to the left
        const double left = kRight - ieee::atan(steepest(-1)) - tilt;
        const double right = kRight - ieee::atan(steepest(1)) + tilt;
        return 0.5 * (ieee::sin(left) + ieee::sin(right));
    }

    std::vector<double> sky_;
};

}  // namespace

Keys<OcclusionOptions> occlusion_keys() {
    return {key("strength",
                Reals{0.0, 100.0},
                "exponent of the visible fraction of the sky; larger values are darker",
                &OcclusionOptions::strength)};
}

Image<float> occlusion_of(const Relief& relief,
                          const RasterGrid& grid,
                          const OcclusionOptions& options) {
    const VisibleSky sky(relief.section(), relief.strength());
    Image<float> image(grid.width, grid.height, 1);
    for (std::size_t k = 0; k < image.samples().size(); ++k) {
        const double distance =
            relief.unit(k) > 0.0 ? relief.section().distance(relief.smooth(k)) : kFar;
        const double visible = distance < kFar ? sky.at(distance) : 1.0;
        image.samples()[k] = static_cast<float>(visible);
    }
    if (options.strength == 1.0) {
        return image;
    }
    const std::span<float> samples = image.samples();
    at_simd_level([samples, strength = options.strength] {
        for (std::size_t k = 0; k < samples.size(); ++k) {
            samples[k] = static_cast<float>(ieee::pow_of_positive(samples[k], strength));
        }
    });
    return image;
}

NumberPixels draw_occlusion(FrameLayers& layers,
                            const ReliefSource& source,
                            const OcclusionOptions& options) {
    const Relief relief(layers, source, ReliefSection::kSkyReach);
    return {occlusion_of(relief, layers.grid(), options), 0.0, 1.0};
}

}  // namespace foam::texgen
