// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "core/foam/measure.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/degree.h"
#include "texgen/maps/smooth_step.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

// The grain (a fine texture of noise, grain.h) has its full height where the smooth distance from
// films is at least this, in diameters of the mean bubble.
constexpr double kGrainFade = 0.12;

// Returns for each bubble the radius, in pixels, of a circle with its area. The table is indexed by
// the ids of the distance field.
std::vector<double> dome_radii(FrameLayers& layers) {
    const Frame& frame = layers.frame();
    const double scale = pixels_per_unit(layers.grid(), frame.domain);
    const auto radii = per_bubble<double>(
        frame,
        [&](BubbleId bubble) {
            return scale * std::sqrt(frame.bubbles[bubble].area / std::numbers::pi);
        },
        [&](const LoneBubble& bubble) { return scale * lone_radius(bubble); });
    return by_cell_id(layers, radii, 0.0);
}

}  // namespace

Relief::Relief(FrameLayers& layers, const ReliefSource& source, double reach)
    : section_(source.relief.profile, source.relief.angle * kDegree),
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
        radii_ = dome_radii(layers);
    }
    if (source.relief.grain > 0.0) {
        // On flat ground, the grain only rises, so that no height is negative.
        const double mean = source.relief.profile == ReliefProfile::Dome ? 0.0 : kGrainBound;
        grain_.emplace(layers, source.relief.grain_size, GrainUse::Relief, mean);
    }
}

GrainValue Relief::grain_at(std::size_t index) const {
    const GrainValue grain = grain_->at(index);
    const double range = kGrainFade * diameter_;
    const double passed = static_cast<double>(smooth_->samples()[index]) / range;
    if (passed >= 1.0) {
        return {grain_height_ * grain.value, grain_height_ * grain.gradient};
    }
    const auto inward = gradient_->samples().subspan(2 * index, 2);
    const double fade = smooth_step(passed);
    const Vec2 fade_slope = smooth_step_slope(passed) / range * Vec2(inward[0], inward[1]);
    return {grain_height_ * fade * grain.value,
            grain_height_ * (fade * grain.gradient + grain.value * fade_slope)};
}

double Relief::height(std::size_t index) const {
    const double length_unit = unit(index);
    const double height =
        length_unit > 0.0 ? strength_ * length_unit * section_.height(smooth(index)) : 0.0;
    return grain_ ? height + grain_at(index).value : height;
}

Vec2 Relief::slope(std::size_t index) const {
    if (!(unit(index) > 0.0)) {
        return Vec2::Zero();
    }
    const auto gradient = gradient_->samples().subspan(2 * index, 2);
    const Vec2 slope = strength_ * section_.slope(smooth(index)) * Vec2(gradient[0], gradient[1]);
    return grain_ ? Vec2(slope + grain_at(index).gradient) : slope;
}

}  // namespace foam::texgen
