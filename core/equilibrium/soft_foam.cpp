// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/soft_foam.h"

#include "core/foam/measure.h"
#include "core/geometry/elementary.h"

#include <cmath>

namespace foam {

// The pressure of a soft bubble is p + slope * (A_target - A), where p is the present multiplier of
// its area constraint (E4). This pressure is the first-order estimate of the next multiplier in the
// method of multipliers (Hestenes 1969; Powell 1969; Nocedal and Wright, Numerical Optimization,
// 2006, section 17.3). The slope is B / A_target^1.5 (E4). A relative area error therefore changes
// the pressure by this error times B / sqrt(A_target), so that small and large bubbles are equally
// stiff for their size. Areas are not measured after each move: a move changes the areas of few
// bubbles, and only their changes are added. A T1 changes the polygons of its bubbles, which are
// then measured again (`renew`).

namespace {

// A bubble with less than this fraction of its target area counts as empty.
constexpr double kEmptyFraction = 0.5;

SoftFoam::Arc arc_of(double half_angle) {
    const auto [sine, cosine] = ieee::sincos(half_angle);
    return {half_angle, sine, cosine, arc_shape(half_angle)};
}

}  // namespace

void SoftFoam::begin(double stiffness) {
    stiffness_ = stiffness;
    for (const BubbleId bubble : loaded_) {
        bubbles_[bubble] = {};
    }
    loaded_.clear();
    bubbles_.resize(foam_.network.bubble_slots());
    arcs_.resize(foam_.network.film_slots());
}

void SoftFoam::load(BubbleId bubble) {
    const bool can_load = foam_.network.is_live(bubble) && bubble != foam_.network.ghost();
    if (!can_load || bubbles_[bubble].target > 0.0) {
        return;
    }
    const double target = foam_.target_areas[bubble];
    const double slope = stiffness_ * foam_.film_tension / (target * std::sqrt(target));
    bubbles_[bubble] = {0.0, foam_.pressures[bubble], slope, target};
    loaded_.push_back(bubble);
    for (const HalfEdgeId h : foam_.network.around(bubble)) {
        load_arc(film_of(h));
    }
    measure(bubble);
}

void SoftFoam::update_multiplier(BubbleId bubble) {
    bubbles_[bubble].pressure_at_target = pressure(bubble);
}

void SoftFoam::measure(BubbleId bubble) {
    double area = polygon_area(foam_, bubble);
    for (const HalfEdgeId h : foam_.network.around(bubble)) {
        area += 0.25 * segment_of(h) * chord(foam_, h).squaredNorm();
    }
    bubbles_[bubble].area = area;
}

void SoftFoam::load_arc(FilmId film) {
    arcs_[film] = arc_of(film_arc(foam_, forward_side(film)).half_angle);
}

void SoftFoam::set_arc(FilmId film,
                       double half_angle,
                       double squared_before,
                       double squared_after) {
    const HalfEdgeId h = forward_side(film);
    const double before = squared_before * arcs_[film].shape.segment;
    if (half_angle != arcs_[film].half_angle) {
        bend_to(film, half_angle);
    }
    const double area = 0.25 * (squared_after * arcs_[film].shape.segment - before);
    bubbles_[foam_.network.left(h)].area += area;
    bubbles_[foam_.network.right(h)].area -= area;
}

void SoftFoam::bend_to(FilmId film, double half_angle) {
    if (foam_.network.is_outer(film)) {
        set_half_angle(foam_, forward_side(film), half_angle);
        arcs_[film] = arc_of(foam_.half_angles[film]);
    } else {
        arcs_[film] = arc_of(half_angle);
    }
}

void SoftFoam::renew(BubbleId bubble, bool may_be_empty) {
    load_outer_arcs(bubble);
    measure(bubble);
    if (may_be_empty && bubbles_[bubble].area < kEmptyFraction * bubbles_[bubble].target) {
        bulge_outer_films(foam_, bubble);
        load_outer_arcs(bubble);
        measure(bubble);
    }
}

void SoftFoam::load_outer_arcs(BubbleId bubble) {
    for (const HalfEdgeId h : foam_.network.around(bubble)) {
        if (foam_.network.is_outer(film_of(h))) {
            load_arc(film_of(h));
        }
    }
}

void bulge_outer_films(Foam& foam, BubbleId bubble) {
    std::vector<HalfEdgeId> outer;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        if (foam.network.is_outer(film_of(h))) {
            outer.push_back(h);
        }
    }
    const double missing = (foam.target_areas[bubble] - polygon_area(foam, bubble)) /
                           static_cast<double>(outer.size());
    for (const HalfEdgeId h : outer) {
        const double squared = chord(foam, h).squaredNorm();
        const double angle = squared > 0.0 ? half_angle_of_segment(4.0 * missing / squared) : 0.0;
        set_half_angle(foam, h, angle);
    }
}

}  // namespace foam
