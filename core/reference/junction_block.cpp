// SPDX-License-Identifier: Apache-2.0

#include "core/reference/junction_block.h"

#include "core/geometry/bulge_energy.h"
#include "core/geometry/elementary.h"
#include "core/geometry/film_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam {

// A JunctionBlock copies data from the foam: the chords, pressure differences and half angles of
// the films around the block's bubbles and at its junction. The errors of the constraints after a
// change of the unknowns are computed from this copy; the foam is not changed. Areas are computed
// by the shoelace formula plus the segments between arcs and chords (E1). Angles are computed from
// the tangents of the arcs at the junction.

namespace {

using Eigen::Index;

constexpr double kPi = std::numbers::pi;

template <class Id>
int find_in(std::span<const Id> known, Id id, int if_none) {
    const auto found = std::find(known.begin(), known.end(), id);
    return found == known.end() ? if_none : static_cast<int>(found - known.begin());
}

}  // namespace

void JunctionBlock::load(const Foam& foam, JunctionId junction) {
    junction_ = junction;
    tension_ = foam.film_tension;
    bubble_count_ = 0;
    outer_films_.clear();
    sides_.clear();
    const std::array<HalfEdgeId, 3> leaving = foam.network.leaving(junction);
    for (const HalfEdgeId h : leaving) {
        add_bubble(foam, foam.network.left(h));
    }
    if (foam.network.ghost() != kNone<BubbleId>) {
        for (const BubbleId bubble : bubbles()) {
            add_outer_films(foam.network, bubble);
        }
    }
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k) {
        leaving_[k] = side_of(foam, leaving[k]);
        lengths[k] = leaving_[k].chord.norm();
    }
    move_unit_ = *std::min_element(lengths.begin(), lengths.end());
    for (const BubbleId bubble : bubbles()) {
        add_sides(foam, bubble);
    }
}

void JunctionBlock::add_bubble(const Foam& foam, BubbleId bubble) {
    if (find(bubble) == kNoUnknown && bubble != foam.network.ghost()) {
        bubbles_[bubble_count_] = bubble;
        targets_[bubble_count_] = foam.target_areas[bubble];
        pressure_units_[bubble_count_] = 1.0 / std::sqrt(foam.target_areas[bubble]);
        ++bubble_count_;
    }
}

void JunctionBlock::add_outer_films(const Network& network, BubbleId bubble) {
    const HalfEdgeId first = network.first(bubble);
    HalfEdgeId h = first;
    do {
        if (network.is_outer(film_of(h))) {
            outer_films_.push_back(film_of(h));
        }
        h = network.next(h);
    } while (h != first);
}

int JunctionBlock::find(BubbleId bubble) const {
    return find_in(bubbles(), bubble, kNoUnknown);
}

int JunctionBlock::find(FilmId film) const {
    return find_in(outer_films(), film, kNoUnknown);
}

FilmArc JunctionBlock::arc_of(const Side& side) {
    return {side.chord,
            side.outer == kNoUnknown
                ? laplace_young_half_angle(side.chord.norm(), side.pressure, 1.0)
                : side.half_angle};
}

double JunctionBlock::direction_at_tail(const Side& side) {
    return ieee::atan2(side.chord.y(), side.chord.x()) - arc_of(side).half_angle;
}

double JunctionBlock::segment_of(const Side& side) {
    return side.outer == kNoUnknown ? film_energy(side.chord, side.pressure, 1.0).segment_area
                                    : segment_area(arc_of(side));
}

JunctionBlock::Side JunctionBlock::side_of(const Foam& foam, HalfEdgeId h) const {
    Side side;
    side.chord = chord(foam, h);
    side.pressure = pressure_difference(foam, h) / tension_;
    side.outer = find(film_of(h));
    if (side.outer != kNoUnknown) {
        side.half_angle = film_arc(foam, h).half_angle;
        side.forward_sign = is_forward(h) ? 1.0 : -1.0;
    }
    side.segment = segment_of(side);
    side.start_weight = foam.network.tail(h) == junction_ ? 1.0 : 0.0;
    side.chord_weight = (foam.network.head(h) == junction_ ? 1.0 : 0.0) - side.start_weight;
    side.left = find(foam.network.left(h));
    side.right = find(foam.network.right(h));
    return side;
}

void JunctionBlock::add_sides(const Foam& foam, BubbleId bubble) {
    const HalfEdgeId first = foam.network.first(bubble);
    Vec2 start(0.0, 0.0);
    HalfEdgeId h = first;
    do {
        Side side = side_of(foam, h);
        side.start = start;
        start += side.chord;
        sides_.push_back(side);
        h = foam.network.next(h);
    } while (h != first);
}

double JunctionBlock::pressure_change_at(const BlockVector& change, int index) const {
    return index == kNoUnknown ? 0.0
                               : pressure_units_[static_cast<std::size_t>(index)] * change[index];
}

double JunctionBlock::pressure_change(const BlockVector& change, std::size_t bubble) const {
    return tension_ * pressure_units_[bubble] * change[static_cast<Index>(bubble)];
}

JunctionBlock::Side JunctionBlock::changed(const Side& side, const BlockVector& change) const {
    Side result = side;
    result.start += side.start_weight * move(change);
    result.chord += side.chord_weight * move(change);
    result.pressure +=
        pressure_change_at(change, side.left) - pressure_change_at(change, side.right);
    if (side.outer != kNoUnknown) {
        result.half_angle +=
            side.forward_sign * half_angle_change(change, static_cast<std::size_t>(side.outer));
    }
    if (result.chord != side.chord || result.pressure != side.pressure ||
        result.half_angle != side.half_angle) {
        result.segment = segment_of(result);
    }
    return result;
}

BlockVector JunctionBlock::constraint_errors(const BlockVector& change) const {
    BlockVector errors = BlockVector::Ones(size());
    for (const Side& side : sides_) {
        const Side now = changed(side, change);
        const double area = 0.5 * cross(now.start, now.chord) + now.segment;
        errors[side.left] -= area / targets_[static_cast<std::size_t>(side.left)];
        if (side.outer != kNoUnknown) {
            errors[static_cast<Index>(bubble_count_) + side.outer] =
                -side.forward_sign * laplace_young_error(arc_of(now), now.pressure, 1.0);
        }
    }
    std::array<double, 3> directions{};
    for (std::size_t k = 0; k < 3; ++k) {
        directions[k] = direction_at_tail(changed(leaving_[k], change));
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const double angle = directions[(k + 2) % 3] - directions[k];
        errors[size() - 2 + static_cast<Index>(k)] =
            std::remainder(2.0 * kPi / 3.0 - angle, 2.0 * kPi);
    }
    return errors;
}

}  // namespace foam
