// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/equilibrate_given.h"

#include "core/foam/measure.h"
#include "core/foam/t1_rule.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace foam {

// The foam is scaled to a mean bubble area of 1 and a film tension of 1, since the default
// thresholds (TopologyThresholds) apply to these units. Up to three attempts start from the given
// state: Newton's method without an initial relaxation, then relaxation and Newton's method, and
// finally both with T1s. Each attempt may change more of the state than the attempt before. If T1s
// are due at many films (kFewDueT1), as in a raw diagram, only the last attempt is made. A raw
// diagram has no equilibrium with its own topology, and the attempts to find one would take longer
// than the last attempt alone.

namespace {

constexpr TopologyThresholds kKeepTopology{.t1_distance = 0.0, .t2_area = 0.0};

// T1s are due at many films if they are due at more than kFewDueT1 films and at more than the
// fraction kSmallDueFraction of all films. The topology of the foam is then not kept. In raw
// diagrams of 1,000 bubbles, T1s are due at 2.5 % to 3.7 % of the films. In the reference foams of
// Surface Evolver (tests/data/evolver), T1s are due at no film.
constexpr std::size_t kFewDueT1 = 5;
constexpr double kSmallDueFraction = 0.01;

// A unit of length that differs from 1 by less than this counts as 1, so that lengths are not
// scaled.
constexpr double kRounding = 1e-9;

// The units of length and tension in which the bubbles of the network have a mean area of 1 and the
// film tension is 1.
struct Units {
    double length = 1.0;
    double tension = 1.0;

    double pressure() const { return tension / length; }
};

double total_area(const Foam& foam) {
    if (!foam.domain.is_plane()) {
        return foam.domain.area();
    }
    double total = 0.0;
    for (const BubbleId bubble : foam.network.bubbles()) {
        total += foam.target_areas[bubble];
    }
    return total;
}

Units units_of(const Foam& foam) {
    if (foam.network.bubble_count() == 0) {  // no bubbles whose mean area could give the unit
        return {1.0, foam.film_tension};
    }
    const auto bubbles = static_cast<double>(foam.network.bubble_count());
    const double length = std::sqrt(total_area(foam) / bubbles);
    return {std::abs(length - 1.0) < kRounding ? 1.0 : length, foam.film_tension};
}

void scale_lone_bubbles(Foam& foam, double factor) {
    for (LoneBubble& bubble : foam.lone_bubbles) {
        bubble.center *= factor;
        bubble.target_area *= factor * factor;
    }
}

// Returns the foam in the given units, without its events.
Foam in_units(Foam foam, const Units& units) {
    foam.events.clear();
    foam.domain = {foam.domain.width / units.length,
                   foam.domain.height / units.length,
                   foam.domain.shear / units.length};
    foam.film_tension = 1.0;
    for (const JunctionId junction : foam.network.junctions()) {
        place_junction(foam, junction, foam.positions[junction] / units.length);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.pressures[bubble] /= units.pressure();
        foam.target_areas[bubble] /= units.length * units.length;
    }
    scale_lone_bubbles(foam, 1.0 / units.length);
    return foam;
}

// Copies the solution to the foam, in the units of the foam. The domain, the film tension and the
// target areas keep their exact values. The events of the solution are appended to the events of
// the foam.
void take_solution(Foam& foam, Foam solved, const Units& units) {
    foam.network = std::move(solved.network);
    foam.t1_armed = std::move(solved.t1_armed);
    foam.half_angles = std::move(solved.half_angles);
    if (solved.lone_bubbles.size() != foam.lone_bubbles.size()) {  // a bubble left its raft
        foam.lone_bubbles = std::move(solved.lone_bubbles);
        scale_lone_bubbles(foam, units.length);
    }
    for (const JunctionId junction : foam.network.junctions()) {
        place_junction(foam, junction, solved.positions[junction] * units.length);
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.pressures[bubble] = solved.pressures[bubble] * units.pressure();
    }
    for (TopologyEvent& event : solved.events) {
        event.position *= units.length;
        foam.events.push_back(std::move(event));
    }
}

bool has_many_due_t1(const Foam& foam) {
    const std::size_t due = short_films(foam, TopologyThresholds{}).size();
    const auto films = static_cast<double>(foam.network.film_count());
    return due > kFewDueT1 && static_cast<double>(due) > kSmallDueFraction * films;
}

// Returns the options of the attempts to bring a foam, in units of mean area 1, to equilibrium.
std::vector<EquilibriumOptions> attempts(const Foam& foam, int threads) {
    EquilibriumOptions with_t1;
    with_t1.threads = threads;
    if (has_many_due_t1(foam)) {
        return {with_t1};
    }
    EquilibriumOptions newton;
    newton.thresholds = kKeepTopology;
    newton.relaxes_first = false;
    newton.threads = threads;
    newton.max_rounds = 1;
    EquilibriumOptions relaxed = newton;
    relaxed.relaxes_first = true;
    relaxed.max_rounds = 3;
    return {newton, relaxed, with_t1};
}

}  // namespace

EquilibriumSummary equilibrate_given(Foam& foam,
                                     int threads,
                                     const std::function<void()>& on_round) {
    const Units units = units_of(foam);
    const Foam given = in_units(foam, units);
    EquilibriumSummary summary;
    for (EquilibriumOptions options : attempts(given, threads)) {
        options.on_round = on_round;
        Foam trial = given;
        EquilibriumSummary attempt = equilibrate(trial, options);
        attempt.add_work(summary);
        summary = attempt;
        if (summary.converged()) {
            if (options.thresholds.t1_distance == 0.0) {
                // A film that has flipped is disarmed (Foam::t1_armed) until it is longer than
                // twice its T1 distance (rearm_grown_films). With the distance 0 the solver has
                // therefore armed all films. Restore the given flags, and arm only the disarmed
                // films that are longer than twice their default T1 distance.
                trial.t1_armed = given.t1_armed;
                rearm_grown_films(trial, TopologyThresholds{});
            }
            take_solution(foam, std::move(trial), units);
            summary.energy = energy(foam);
            break;
        }
    }
    return summary;
}

}  // namespace foam
