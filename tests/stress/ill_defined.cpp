// SPDX-License-Identifier: Apache-2.0

#include "tests/stress/ill_defined.h"

#include "core/equilibrium/untangle.h"
#include "core/foam/measure.h"
#include "tests/stress/foam_case.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace foam::stress {

namespace {

constexpr double kPerturbedFraction = 1.0 / 3.0;  // of the junctions
constexpr double kDamagedFraction = 0.1;          // of films or of bubbles

double mean_film_length(const Foam& foam) {
    return energy(foam) / foam.film_tension / static_cast<double>(foam.network.film_count());
}

bool happens(Random& random, double probability) {
    return random.uniform() < probability;
}

// Moves each junction, with the given probability, in a random direction by up to `farthest` mean
// film lengths.
void perturb_junctions(Foam& foam, Random& random, double probability, double farthest) {
    const double length = farthest * mean_film_length(foam);
    for (const JunctionId junction : foam.network.junctions()) {
        const double distance = uniform(random, 0.0, length);
        const double angle = uniform(random, 0.0, 2.0 * std::numbers::pi);
        if (happens(random, probability)) {
            const Vec2 by = distance * Vec2(std::cos(angle), std::sin(angle));
            place_junction(foam, junction, foam.positions[junction] + by);
        }
    }
}

// For a film of mean length c, the changes give |s| = |pressure difference| c / 2T of at most 10
// (E1).
void change_pressures(Foam& foam, Random& random) {
    const double largest = 10.0 * foam.film_tension / mean_film_length(foam);
    for (const BubbleId bubble : foam.network.bubbles()) {
        foam.pressures[bubble] += uniform(random, -largest, largest);
    }
}

void pull_head_to_tail(Foam& foam, HalfEdgeId h) {
    const Vec2 tail = foam.positions[foam.network.tail(h)];
    place_junction(
        foam, foam.network.head(h), tail - foam.domain.translation(foam.network.offset(h)));
}

void collapse_films(Foam& foam, Random& random) {
    for (const FilmId film : foam.network.films()) {
        if (happens(random, kDamagedFraction)) {
            pull_head_to_tail(foam, forward_side(film));
        }
    }
}

void collapse_bubbles(Foam& foam, Random& random) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (happens(random, kDamagedFraction)) {
            for (const HalfEdgeId h : foam.network.around(bubble)) {
                pull_head_to_tail(foam, h);
            }
        }
    }
}

// Mirrors a bubble in the horizontal line through the mean of its junctions.
void mirror(Foam& foam, BubbleId bubble) {
    std::vector<double> heights;  // of the junctions relative to the first one
    Vec2 at = Vec2::Zero();
    double sum = 0.0;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        heights.push_back(at.y());
        sum += at.y();
        at += chord(foam, h);
    }
    const double middle = sum / static_cast<double>(heights.size());
    std::size_t k = 0;
    for (const HalfEdgeId h : foam.network.around(bubble)) {
        const JunctionId junction = foam.network.tail(h);
        const Vec2 up(0.0, 2.0 * (middle - heights[k++]));
        place_junction(foam, junction, foam.positions[junction] + up);
    }
}

void invert_bubbles(Foam& foam, Random& random) {
    for (const BubbleId bubble : foam.network.bubbles()) {
        if (happens(random, kDamagedFraction)) {
            mirror(foam, bubble);
        }
    }
}

}  // namespace

const char* name_of(Damage damage) {
    switch (damage) {
        case Damage::PartlyPerturbed:
            return "half thrown";
        case Damage::Perturbed:
            return "thrown";
        case Damage::Pressures:
            return "pressures";
        case Damage::ZeroFilms:
            return "zero films";
        case Damage::Coincident:
            return "coincident";
        case Damage::Inverted:
            return "inside out";
        case Damage::All:
            return "all";
    }
    return "unknown damage";
}

void apply(Damage damage, Foam& foam, Random& random) {
    const bool all = damage == Damage::All;
    if (damage == Damage::PartlyPerturbed) {
        perturb_junctions(foam, random, kPerturbedFraction, 0.5);
    }
    if (all || damage == Damage::Perturbed) {
        perturb_junctions(foam, random, 1.0, 1.0);
    }
    if (all || damage == Damage::Pressures) {
        change_pressures(foam, random);
    }
    if (all || damage == Damage::ZeroFilms) {
        collapse_films(foam, random);
    }
    if (all || damage == Damage::Coincident) {
        collapse_bubbles(foam, random);
    }
    if (all || damage == Damage::Inverted) {
        invert_bubbles(foam, random);
    }
}

IllDefined count_ill_defined(const Foam& foam) {
    IllDefined counts;
    counts.films_at_limit = equilibrium_errors(foam).films_at_limit;
    for (const FilmId film : foam.network.films()) {
        counts.zero_films += chord(foam, forward_side(film)).norm() < 1e-12 ? 1 : 0;
    }
    for (const JunctionId junction : foam.network.junctions()) {
        counts.tangled_junctions += is_tangled(foam, junction) ? 1 : 0;
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        counts.inverted_bubbles += polygon_area(foam, bubble) < 0.0 ? 1 : 0;
    }
    return counts;
}

std::string describe(const IllDefined& counts) {
    return fmt::format(
        "{} films at the limit, {} of no length, {} junctions tangled, {} bubbles inside out",
        counts.films_at_limit,
        counts.zero_films,
        counts.tangled_junctions,
        counts.inverted_bubbles);
}

}  // namespace foam::stress
