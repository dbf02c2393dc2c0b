// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "texgen/maps/cell_fill.h"
#include "texgen/maps/degree.h"
#include "texgen/maps/smooth_step.h"

#include <cassert>

// The relief is a height field. The height depends on a distance: the smooth distance from films
// (A. Biswas and V. Shapiro, "Approximate distance fields with non-vanishing gradients", 2004), or
// the distance from the walls of a maze. To use these distances for a relief is our own idea. The
// function that gives the height at a distance is the section (relief_section.h); each profile has
// its own. Slopes follow from the gradient of the distance by the chain rule. The grain (grain.h)
// is multiplied by a factor that fades it out toward films; its slopes follow by the product rule.
// All slopes are exact derivatives, as in bump mapping (J. F. Blinn, "Simulation of wrinkled
// surfaces", 1978). Differences between pixels would depend on the size of the image.

namespace foam::texgen {

namespace {

// The grain is a fine texture of noise (grain.h). It has its full height where the smooth distance
// from films (DistanceField::smooth) is at least this number of diameters of the mean bubble.
constexpr double kGrainFade = 0.12;

}  // namespace

Relief::Relief(FrameLayers& layers, const ReliefSource& source, double reach)
    : layers_(layers),
      section_(source.relief.profile, source.relief.angle * kDegree),
      strength_(source.relief.strength),
      diameter_(diameter_of(source.relief.mean_bubble, layers.frame()) *
                pixels_per_unit(layers.grid(), layers.frame().domain)),
      width_(source.relief.width * diameter_),
      grain_height_(strength_ * source.relief.grain * diameter_) {
    if (source.relief.films == ReliefFilms::Walls) {
        const ArcDistances& walls = layers.wall_distances(
            maze_rule(source.maze), {.reach = reach * width_, .gradient = true});
        smooth_ = &walls.distance;
        gradient_ = &walls.gradient;
        return;
    }
    const DistanceField& field = layers.distance();
    smooth_ = &field.smooth;
    gradient_ = &field.smooth_gradient;
    if (source.relief.profile == ReliefProfile::Dome) {
        ids_ = &field.ids;
        radii_ = radii_by_cell_id(layers, 0.0);
    }
    if (source.relief.grain > 0.0) {
        // The bubbles between ridges or wet films are flat and have the height 0. A grain with the
        // mean kGrainBound is never negative, so that no height is negative.
        const double mean = source.relief.profile == ReliefProfile::Dome ? 0.0 : kGrainBound;
        grain_ = {source.relief.grain_size, GrainUse::Relief, mean};
    }
}

// The grain is multiplied by a factor that rises smoothly from 0 on films to 1 at the smooth
// distance kGrainFade.
void Relief::add_grain(const Grain& grain, Image<float>& heights) const {
    at_simd_level([count = heights.samples().size(),
                   to = heights.samples().data(),
                   values = grain.value.samples().data(),
                   distances = smooth_->samples().data(),
                   range = kGrainFade * diameter_,
                   height = grain_height_] {
        for (std::size_t k = 0; k < count; ++k) {
            const double passed = min_value(static_cast<double>(distances[k]) / range, 1.0);
            const double fade = smooth_step(passed);
            to[k] += static_cast<float>(height * fade * static_cast<double>(values[k]));
        }
    });
}

void Relief::add_grain(const Grain& grain, PixelSlopes& slopes) const {
    at_simd_level([count = slopes.x.samples().size(),
                   to_x = slopes.x.samples().data(),
                   to_y = slopes.y.samples().data(),
                   values = grain.value.samples().data(),
                   slopes_x = grain.slope_x.samples().data(),
                   slopes_y = grain.slope_y.samples().data(),
                   distances = smooth_->samples().data(),
                   gradient = gradient_->samples().data(),
                   range = kGrainFade * diameter_,
                   height = grain_height_] {
        for (std::size_t k = 0; k < count; ++k) {
            const double passed = min_value(static_cast<double>(distances[k]) / range, 1.0);
            const double fade = height * smooth_step(passed);
            const double fade_slope =
                height * smooth_step_slope(passed) / range * static_cast<double>(values[k]);
            to_x[k] += static_cast<float>(fade * static_cast<double>(slopes_x[k]) +
                                          fade_slope * static_cast<double>(gradient[2 * k]));
            to_y[k] += static_cast<float>(fade * static_cast<double>(slopes_y[k]) +
                                          fade_slope * static_cast<double>(gradient[2 * k + 1]));
        }
    });
}

Image<float> Relief::heights() const {
    Image<float> image(smooth_->width(), smooth_->height(), 1);
    for_all_pixels([heights = image.samples().data(), strength = strength_](
                       const auto& section, double smooth, double unit, std::size_t k) {
        const double height = strength * unit * section.height(smooth);
        heights[k] = static_cast<float>(unit > 0.0 ? height : 0.0);
    });
    if (grain_) {
        add_grain(layers_.grain(*grain_), image);
    }
    return image;
}

PixelSlopes Relief::slopes() const {
    assert(!gradient_->samples().empty());
    PixelSlopes image{Image<float>(smooth_->width(), smooth_->height(), 1),
                      Image<float>(smooth_->width(), smooth_->height(), 1)};
    for_all_pixels(
        [x = image.x.samples().data(),
         y = image.y.samples().data(),
         gradient = gradient_->samples().data(),
         strength = strength_](const auto& section, double smooth, double unit, std::size_t k) {
            const double slope = unit > 0.0 ? strength * section.slope(smooth) : 0.0;
            x[k] = static_cast<float>(slope * static_cast<double>(gradient[2 * k]));
            y[k] = static_cast<float>(slope * static_cast<double>(gradient[2 * k + 1]));
        });
    if (grain_) {
        add_grain(layers_.grain(*grain_), image);
    }
    return image;
}

}  // namespace foam::texgen
