// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/cycle.h"

#include "core/dynamics/restore_rafts.h"
#include "core/foam/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

// At each position of the cycle, a bubble has the target area A (1 + area_amplitude sin 2 pi (t +
// phase)). A is the target area of the bubble when the Cycle was constructed, and the phase of each
// bubble is random. The shear strain of the torus is strain * sin 2 pi t, relative to the shear
// when the Cycle was constructed. Here t is the position divided by the number of steps. A step
// drives the foam from its present state to these target areas and this shear (state_change.h).
// Drift is removed after each step, because equilibrium does not determine the position of the
// foam.

namespace foam {

namespace {

// Returns the positions of the junctions of a bubble, unwrapped from the first junction.
std::vector<Vec2> corners(const Foam& foam, BubbleId bubble) {
    std::vector<Vec2> all;
    Vec2 at = foam.positions[foam.network.tail(foam.network.first(bubble))];
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        all.push_back(at);
        at += chord(foam, h);
    }
    return all;
}

Vec2 mean(const std::vector<Vec2>& points) {
    Vec2 sum = Vec2::Zero();
    for (const Vec2& point : points) {
        sum += point;
    }
    return sum / static_cast<double>(points.size());
}

// Returns the center of each bubble. On a torus it is the mean of the junctions of the bubble, and
// may belong to any lattice copy of the bubble.
std::map<BubbleIdentity, Vec2> centers(const Foam& foam) {
    if (foam.domain.is_plane()) {
        return bubble_centers(foam);
    }
    std::map<BubbleIdentity, Vec2> all;
    for (const BubbleId bubble : foam.network.bubbles()) {
        all[foam.identities[bubble]] = mean(corners(foam, bubble));
    }
    return all;
}

// Returns the largest distance from a corner in `from` to the nearest corner in `to`, modulo the
// periods of the torus. A translation of the whole foam between the two states is not removed.
double farthest(const Domain& domain, const std::vector<Vec2>& from, const std::vector<Vec2>& to) {
    double largest = 0.0;
    for (const Vec2& a : from) {
        double min_distance = std::numeric_limits<double>::infinity();
        for (const Vec2& b : to) {
            min_distance = std::min(min_distance, domain.nearest_copy(a - b).norm());
        }
        largest = std::max(largest, min_distance);
    }
    return largest;
}

double mean_diameter(const Foam& foam) {
    double area = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        area += foam.target_areas[bubble];
    }
    const auto count = static_cast<double>(foam.network.bubble_count());
    return 2.0 * std::sqrt(area / count * std::numbers::inv_pi);
}

}  // namespace

Cycle::Cycle(const Foam& foam, const CycleOptions& options)
    : options_(options), shear_(foam.domain.shear), centers_(centers(foam)) {
    Random random(options.seed);
    for (const BubbleId bubble : foam.network.bubbles()) {
        oscillations_.push_back(
            {foam.identities[bubble], foam.target_areas[bubble], random.uniform()});
    }
    for (const LoneBubble& bubble : foam.lone_bubbles) {
        oscillations_.push_back({bubble.identity, bubble.target_area, random.uniform()});
    }
}

StepSummary Cycle::step_to(int position,
                           Foam& foam,
                           double time,
                           const StepOptions& options) const {
    StepOptions without_diffusion = options;
    without_diffusion.coarsening.kappa = 0.0;
    const StepSummary summary =
        step(foam, time, change_to(position, foam.domain), without_diffusion);
    restore_positions(foam);
    return summary;
}

// Returns the sine of an oscillation with the given phase, in turns.
double Cycle::sine_at(int position, double phase) const {
    const double turns = static_cast<double>(position % options_.steps) / options_.steps;
    return std::sin(2.0 * std::numbers::pi * (turns + phase));
}

// Returns the strain that leads a torus from the preceding position to the given one. The shear of
// a torus is determined only up to multiples of its width, so the strain is corrected by the number
// of widths that brings it closest to the difference of both positions. Without this correction, a
// tall torus would be sheared by a whole width in each step in which its shear is above half of
// its width.
double Cycle::strain_to(int position, const Domain& domain) const {
    const double target = options_.strain * sine_at(position, 0.0);
    const double before = position > 0 ? options_.strain * sine_at(position - 1, 0.0) : 0.0;
    const double strain = target + (shear_ - domain.shear) / domain.height;
    const double whole_width = domain.width / domain.height;
    return strain - whole_width * std::round((strain - (target - before)) / whole_width);
}

// Returns the change that leads a foam with the given domain to the given position. The position is
// taken modulo the length of a cycle, so that every cycle has the same targets to the last bit.
StateChange Cycle::change_to(int position, const Domain& domain) const {
    StateChange change;
    for (const Oscillation& bubble : oscillations_) {
        const double area =
            bubble.target_area * (1.0 + options_.area_amplitude * sine_at(position, bubble.phase));
        change.driven.push_back({bubble.bubble, area, false});
    }
    if (options_.strain != 0.0) {
        change.strain = strain_to(position, domain);
    }
    return change;
}

// Moves the foam back to where it was at the start: on a torus as a whole, by the mean displacement
// of its bubbles; in a patch each raft by itself.
void Cycle::restore_positions(Foam& foam) const {
    if (foam.domain.is_plane()) {
        restore_rafts(foam, centers_);
        return;
    }
    Vec2 sum = Vec2::Zero();
    std::size_t count = 0;
    for (const auto& [bubble, center] : centers(foam)) {
        if (const auto start = centers_.find(bubble); start != centers_.end()) {
            sum += foam.domain.nearest_copy(center - start->second);
            ++count;
        }
    }
    if (count > 0) {
        translate(foam, -sum / static_cast<double>(count));
    }
}

double closing_error(const Foam& one, const Foam& other) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::map<BubbleIdentity, std::vector<Vec2>> bubbles;
    for (const BubbleId bubble : other.network.bubbles()) {
        bubbles[other.identities[bubble]] = corners(other, bubble);
    }
    if (bubbles.size() != one.network.bubble_count()) {
        return kInfinity;
    }
    double largest = 0.0;
    for (const BubbleId bubble : one.network.bubbles()) {
        const auto found = bubbles.find(one.identities[bubble]);
        const std::vector<Vec2> current = corners(one, bubble);
        if (found == bubbles.end() || found->second.size() != current.size()) {
            return kInfinity;
        }
        largest = std::max(largest, farthest(one.domain, current, found->second));
    }
    return largest / mean_diameter(one);
}

}  // namespace foam
