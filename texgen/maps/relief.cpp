// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "core/foam/measure.h"
#include "texgen/maps/cell_fill.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

// Returns the section's unit of length in pixels, indexed by the ids of the distance field. For
// domes the unit is the radius of a circle with the area of the bubble. For other profiles the unit
// is ReliefOptions::width.
std::vector<double> units_of(FrameLayers& layers, const ReliefOptions& options, double diameter) {
    const Frame& frame = layers.frame();
    if (options.profile != ReliefProfile::Dome) {
        const double width = options.width * diameter;
        const auto constant = [&](const auto&) { return width; };
        return by_cell_id(layers, per_bubble<double>(frame, constant, constant), width);
    }
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

Relief::Relief(FrameLayers& layers, const ReliefOptions& options)
    : field_(layers.distance()),
      section_(options.profile, options.angle * kDegree),
      strength_(options.strength),
      diameter_(diameter_of(options.mean_bubble, layers.frame()) *
                pixels_per_unit(layers.grid(), layers.frame().domain)),
      units_(units_of(layers, options, diameter_)) {}

double Relief::height(std::size_t index) const {
    const double length_unit = unit(index);
    return length_unit > 0.0 ? strength_ * length_unit * section_.height(smooth(index)) : 0.0;
}

Vec2 Relief::slope(std::size_t index) const {
    if (!(unit(index) > 0.0)) {
        return Vec2::Zero();
    }
    const auto gradient = field_.smooth_gradient.samples().subspan(2 * index, 2);
    return strength_ * section_.slope(smooth(index)) * Vec2(gradient[0], gradient[1]);
}

}  // namespace foam::texgen
