// SPDX-License-Identifier: Apache-2.0

#include "texgen/maps/relief.h"

#include "core/foam/measure.h"
#include "texgen/maps/cell_fill.h"
#include "texgen/maps/degree.h"

#include <cmath>
#include <numbers>

namespace foam::texgen {

namespace {

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
      width_(source.relief.width * diameter_) {
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
}

double Relief::height(std::size_t index) const {
    const double length_unit = unit(index);
    return length_unit > 0.0 ? strength_ * length_unit * section_.height(smooth(index)) : 0.0;
}

Vec2 Relief::slope(std::size_t index) const {
    if (!(unit(index) > 0.0)) {
        return Vec2::Zero();
    }
    const auto gradient = gradient_->samples().subspan(2 * index, 2);
    return strength_ * section_.slope(smooth(index)) * Vec2(gradient[0], gradient[1]);
}

}  // namespace foam::texgen
