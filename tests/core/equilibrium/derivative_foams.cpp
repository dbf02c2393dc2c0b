// SPDX-License-Identifier: Apache-2.0

#include "tests/core/equilibrium/derivative_foams.h"

#include "core/equilibrium/hessian.h"
#include "core/foam/honeycomb.h"
#include "core/foam/random.h"
#include "tests/core/patches.h"
#include "tests/support/sample_foams.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace foam::test {

namespace {

// Moves every junction at random by up to `largest` in x and in y.
Foam perturbed(Foam foam, double largest) {
    Random random(17);
    for (const JunctionId junction : foam.network.junctions()) {
        const double x = largest * (2.0 * random.uniform() - 1.0);
        const double y = largest * (2.0 * random.uniform() - 1.0);
        place_junction(foam, junction, foam.positions[junction] + Vec2(x, y));
    }
    return foam;
}

double shortest_film(const Foam& foam) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const FilmId film : foam.network.films()) {
        shortest = std::min(shortest, chord(foam, forward_side(film)).norm());
    }
    return shortest;
}

// Returns the foam of the first seed, from 1 on, whose films are all longer than 0.05.
Foam bent_foam_of_long_films(int bubbles, double pressure) {
    for (std::uint64_t seed = 1;; ++seed) {
        Foam foam = bent_foam(bubbles, pressure, seed);
        if (shortest_film(foam) > 0.05) {
            return foam;
        }
    }
}

}  // namespace

std::vector<Foam> derivative_foams() {
    std::vector<Foam> foams{perturbed(single_bubble(), 0.05), perturbed(honeycomb(1, 2), 0.1)};
    for (const int bubbles : {2, 3, 4, 12}) {
        for (const double pressure : {0.5, 10.0}) {
            foams.push_back(bent_foam_of_long_films(bubbles, pressure));
            foams.back().film_tension = 1.6;
        }
    }
    return foams;
}

std::vector<Foam> derivative_patches() {
    std::vector<Foam> foams{
        double_bubble(1.0, 3.0), triple_bubble(1.0), flower(1.0), chain(), ring()};
    Random random(5);
    for (Foam& foam : foams) {
        foam.film_tension = 1.6;
        foam = perturbed(std::move(foam), 0.1);
        for (const BubbleId bubble : foam.network.bubbles()) {
            foam.pressures[bubble] = 4.0 * random.uniform() - 1.0;
        }
        for (double& angle : foam.half_angles) {
            angle = 5.0 * random.uniform() - 2.5;
        }
    }
    return foams;
}

Eigen::MatrixXd full_hessian(const Foam& foam, const Unknowns& unknowns) {
    Hessian hessian(foam.network, unknowns);
    const Eigen::MatrixXd lower = hessian.evaluate(foam);
    Eigen::MatrixXd full = lower.selfadjointView<Eigen::Lower>();
    return full;
}

Foam shifted(Foam foam, const Unknowns& unknowns, int row, double by) {
    if (row < unknowns.first_pressure_row()) {
        foam.positions[unknowns.junctions[static_cast<std::size_t>(row / 2)]][row % 2] += by;
    } else if (row < unknowns.first_angle_row()) {
        const int rank = row - unknowns.first_pressure_row();
        foam.pressures[unknowns.bubbles[static_cast<std::size_t>(rank)]] += by;
    } else {
        const int rank = row - unknowns.first_angle_row();
        foam.half_angles[unknowns.outer_films[static_cast<std::size_t>(rank)]] += by;
    }
    return foam;
}

}  // namespace foam::test
