// SPDX-License-Identifier: Apache-2.0

#include "core/dynamics/cycle.h"

#include "core/dynamics/restore_rafts.h"
#include "core/foam/corners.h"
#include "core/foam/locate.h"
#include "core/geometry/elementary.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

// A position of the cycle is a number of steps since its start. The time t of a position is the
// position divided by the number of steps per cycle. At each position, the target area of a bubble
// is A (1 + amplitude sin 2 pi (t + phase)). A is the mean area of the bubble, and each bubble has
// its own phase (cycle_drive.h). The shear strain of the torus is strain * sin 2 pi t, relative to
// the shear that the torus had when the Cycle was constructed. A step drives the foam from its
// present state to these target areas and this shear (state_change.h). After each step, the foam is
// moved back to where it was at the start (restore_positions), because equilibrium does not
// determine where the foam is.
//
// Boiling bubbles have the target areas of boiling.h instead. A system that is driven periodically
// either reaches a periodic state or keeps changing. In a sheared suspension, the amplitude of the
// drive decides which of the two happens (L. Corte, P. M. Chaikin, J. P. Gollub and D. J. Pine,
// "Random organization in periodically driven systems", Nature Physics 4, 2008). `calm` lowers the
// amplitudes where the foam keeps changing, until it is periodic everywhere.

namespace foam {

namespace {

// A bubble is restless if it keeps getting other neighbors from cycle to cycle (unrest.h).
// Cycle::calm multiplies the amplitudes of restless bubbles by this factor, and also the area rises
// (BoilingBubble::area_rise) of the boiling bubbles nearest to them.
constexpr double kCalming = 0.8;

// Returns the center of each bubble: in a patch the mean of all points of its films
// (bubble_centers), on a torus the mean of its junctions (mean_corner).
std::map<BubbleIdentity, Vec2> centers(const Foam& foam) {
    if (foam.domain.is_plane()) {
        return bubble_centers(foam);
    }
    std::map<BubbleIdentity, Vec2> all;
    for (const BubbleId bubble : foam.network.bubbles()) {
        all[foam.identities[bubble]] = mean_corner(foam, bubble);
    }
    return all;
}

// Returns the largest distance from a corner in `corners` to the nearest corner in `other_corners`,
// modulo the periods of the torus. If the whole foam has moved between the two states to which the
// corners belong, this motion counts as distance, too.
double largest_distance(const Domain& domain,
                        const std::vector<Vec2>& corners,
                        const std::vector<Vec2>& other_corners) {
    double largest = 0.0;
    for (const Vec2& a : corners) {
        double min_distance = std::numeric_limits<double>::infinity();
        for (const Vec2& b : other_corners) {
            min_distance = std::min(min_distance, domain.nearest_copy(a - b).norm());
        }
        largest = std::max(largest, min_distance);
    }
    return largest;
}

// Returns the target area of a boiling bubble at its birth.
double first_area(const TopologyThresholds& thresholds) {
    return 2.0 * thresholds.t2_area;
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
    : Cycle(foam, options, random_drive(foam, options)) {}

Cycle::Cycle(const Foam& foam, const CycleOptions& options, CycleDrive drive)
    : options_(options),
      shear_(foam.domain.shear),
      drive_(std::move(drive)),
      centers_(centers(foam)),
      unrest_(foam) {
    for (const BoilingBubble& bubble : drive_.boiling) {
        centers_.erase(bubble.identity);
    }
}

StepSummary Cycle::step_to(int position, Foam& foam, double time, const StepOptions& options) {
    const TopologyThresholds& thresholds = options.equilibrium.thresholds;
    StepOptions without_diffusion = options;
    without_diffusion.coarsening.kappa = 0.0;
    const std::size_t first_event = foam.events.size();
    give_births(position, foam, first_area(thresholds));
    const StepSummary summary =
        step(foam, time, change_to(position, foam.domain, thresholds), without_diffusion);
    record_ends(foam, first_event, restore_positions(foam));
    return summary;
}

bool Cycle::repeats() const {
    return std::none_of(drive_.boiling.begin(),
                        drive_.boiling.end(),
                        [](const BoilingBubble& bubble) { return bubble.neighbors_changed; });
}

void Cycle::calm(const Foam& foam) {
    if (drive_.boiling.empty()) {
        return;
    }
    const std::vector<BubbleIdentity> restless = unrest_.restless_bubbles(foam);
    const std::map<BubbleIdentity, Vec2> present = centers(foam);
    std::set<BoilingBubble*> near_unrest;
    for (const BubbleIdentity bubble : restless) {
        near_unrest.insert(nearest_with_reducible_rise(foam.domain, present, present.at(bubble)));
    }
    near_unrest.erase(nullptr);
    for (BoilingBubble* bubble : near_unrest) {
        bubble->area_rise *= kCalming;
    }
    for (OscillatingBubble& bubble : drive_.oscillating) {
        if (std::binary_search(restless.begin(), restless.end(), bubble.bubble)) {
            bubble.amplitude *= kCalming;
        }
    }
}

// Returns the value, at a position of the cycle, of a sine that makes one oscillation per cycle.
// `phase` is its phase at the start of the cycle, in turns.
double Cycle::sine_at(int position, double phase) const {
    const double turns = static_cast<double>(position % options_.steps) / options_.steps;
    return ieee::sin(2.0 * std::numbers::pi * (turns + phase));
}

// Returns the change of strain that leads a torus with the given domain to the given position. The
// function `shear` reduces the magnitude of Domain::shear, by whole widths, to at most half of the
// width. The present strain, and so the change, is therefore known only up to multiples of width /
// height. This function returns the change that is nearest to the change of the prescribed strain
// since the position before. Each of the other possible changes would also shear the torus by one
// or more whole widths.
double Cycle::strain_to(int position, const Domain& domain) const {
    const double target = options_.strain * sine_at(position, 0.0);
    const double target_before = position > 0 ? options_.strain * sine_at(position - 1, 0.0) : 0.0;
    const double strain = target + (shear_ - domain.shear) / domain.height;
    const double whole_width = domain.width / domain.height;
    return strain - whole_width * std::round((strain - (target - target_before)) / whole_width);
}

// Adds the boiling bubbles that should be present at the given position of the cycle (area_at) but
// are missing in the foam. If a bubble cannot be born (give_birth), a later step tries again.
void Cycle::give_births(int position, Foam& foam, double first_area) const {
    for (const BoilingBubble& bubble : drive_.boiling) {
        const auto area = area_at(bubble, position, options_.steps, first_area);
        if (area && !is_present(foam, bubble.identity)) {
            give_birth(foam, bubble, std::min(*area, first_area));
        }
    }
}

// Returns the change that leads a foam with the given domain to the given position. The position is
// taken modulo the length of a cycle, so that every cycle has the same targets to the last bit.
StateChange Cycle::change_to(int position,
                             const Domain& domain,
                             const TopologyThresholds& thresholds) const {
    StateChange change;
    for (const OscillatingBubble& bubble : drive_.oscillating) {
        const double area =
            bubble.mean_area * (1.0 + bubble.amplitude * sine_at(position, bubble.phase));
        change.driven.push_back({bubble.bubble, area, false});
    }
    for (const BoilingBubble& bubble : drive_.boiling) {
        const auto area = area_at(bubble, position, options_.steps, first_area(thresholds));
        change.driven.push_back(area ? DrivenBubble{bubble.identity, *area, false}
                                     : forced_collapse(bubble.identity, thresholds));
    }
    if (options_.strain != 0.0) {
        change.strain = strain_to(position, domain);
    }
    return change;
}

// Moves the foam back to where it was at the start. A torus is moved as a whole, by minus the mean
// displacement of the bubbles that do not boil. In a patch, each raft is moved by itself. Returns
// the translation of a torus, or zero for a patch.
Vec2 Cycle::restore_positions(Foam& foam) const {
    if (foam.domain.is_plane()) {
        restore_rafts(foam, centers_);
        return Vec2::Zero();
    }
    Vec2 sum = Vec2::Zero();
    std::size_t count = 0;
    for (const auto& [bubble, center] : centers(foam)) {
        if (const auto start = centers_.find(bubble); start != centers_.end()) {
            sum += foam.domain.nearest_copy(center - start->second);
            ++count;
        }
    }
    if (count == 0) {
        return Vec2::Zero();
    }
    Vec2 translation = -sum / static_cast<double>(count);
    translate(foam, translation);
    return translation;
}

// Records where boiling bubbles have vanished, from the events of the foam since `first_event`.
void Cycle::record_ends(const Foam& foam, std::size_t first_event, const Vec2& translation) {
    for (std::size_t k = first_event; k < foam.events.size(); ++k) {
        const TopologyEvent& event = foam.events[k];
        if (event.kind != TopologyEventKind::T2) {
            continue;
        }
        const auto bubble = std::find_if(
            drive_.boiling.begin(), drive_.boiling.end(), [&](const BoilingBubble& boiling) {
                return boiling.identity == event.bubbles.front();
            });
        if (bubble != drive_.boiling.end()) {
            record_end(*bubble, event, translation);
        }
    }
}

// Returns the boiling bubble nearest to a point among those whose area rise can still be reduced,
// or nullptr if there is none. An absent bubble counts as being where it last vanished.
BoilingBubble* Cycle::nearest_with_reducible_rise(const Domain& domain,
                                                  const std::map<BubbleIdentity, Vec2>& centers,
                                                  const Vec2& point) {
    BoilingBubble* nearest = nullptr;
    double smallest = std::numeric_limits<double>::infinity();
    for (BoilingBubble& bubble : drive_.boiling) {
        const auto present = centers.find(bubble.identity);
        const Vec2& position = present != centers.end() ? present->second : bubble.last_position;
        const double distance = domain.nearest_copy(position - point).norm();
        if (bubble.area_rise * kCalming > bubble.min_area_rise && distance < smallest) {
            smallest = distance;
            nearest = &bubble;
        }
    }
    return nearest;
}

double closing_error(const Foam& one, const Foam& other) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    std::map<BubbleIdentity, std::vector<Vec2>> bubbles;
    for (const BubbleId bubble : other.network.bubbles()) {
        bubbles[other.identities[bubble]] = corners_of(other, bubble);
    }
    if (bubbles.size() != one.network.bubble_count()) {
        return kInfinity;
    }
    if (bubbles.empty()) {
        return 0.0;
    }
    double largest = 0.0;
    for (const BubbleId bubble : one.network.bubbles()) {
        const auto found = bubbles.find(one.identities[bubble]);
        const std::vector<Vec2> current = corners_of(one, bubble);
        if (found == bubbles.end() || found->second.size() != current.size()) {
            return kInfinity;
        }
        largest = std::max(largest, largest_distance(one.domain, current, found->second));
    }
    return largest / mean_diameter(one);
}

}  // namespace foam
