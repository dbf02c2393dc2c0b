// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/residual.h"

#include "core/foam/measure.h"
#include "core/geometry/bulge_energy.h"
#include "core/geometry/film_energy.h"
#include "core/geometry/max_or_nan.h"
#include "core/parallel/parallel_for.h"

#include <cmath>
#include <vector>

namespace foam {

// The residual is the gradient of L (E3) instead of the errors of angles and areas (paper eq. 8).
// Three unit tangents add up to 0 exactly if they meet at 120 degrees, so the gradient is zero in
// the same states as these errors. The advantage of the gradient is its symmetric derivative. It is
// assembled like the Hessian (hessian.cpp). Each film contributes a term to the rows of its ends
// and of its two bubbles. An outer film also contributes a term to the row of its half angle. The
// row of each bubble also contains the target area minus the area of the bubble's polygon. The
// terms of the films are computed in parallel and added in the order of the films. The bits of the
// sums therefore do not depend on the number of threads.

namespace {

constexpr std::size_t kItemsPerChunk = 1024;  // films or bubbles

template <class Body>
void for_each_index(std::size_t count, int threads, const Body& body) {
    parallel_for(count, kItemsPerChunk, threads, [&](std::size_t first, std::size_t last) {
        for (std::size_t k = first; k < last; ++k) {
            body(k);
        }
    });
}

// The derivatives of one film's term in L with respect to its tail, its head, the pressure on its
// right, and its half angle. The derivatives with respect to tail and head include the polygon
// terms (E3). The derivative with respect to the pressure on the left of the film is minus `right`.
struct FilmGradient {
    Vec2 tail = Vec2::Zero();
    Vec2 head = Vec2::Zero();
    double right = 0.0;
    double angle = 0.0;  // only used for an outer film
};

FilmGradient film_gradient(const Foam& foam, FilmId film) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 d = chord(foam, h);
    const double delta = pressure_difference(foam, h);
    // The polygon terms of the gradient at each end (E3).
    const Vec2 polygon_gradient = 0.5 * delta * turned_left(d);
    if (foam.network.is_outer(film)) {
        const BulgeEnergy energy =
            bulge_energy({d, foam.half_angles[film]}, delta, foam.film_tension);
        return {polygon_gradient - energy.gradient,
                polygon_gradient + energy.gradient,
                energy.segment_area,
                energy.angle_derivative};
    }
    const FilmEnergy energy = film_energy(d, delta, foam.film_tension);
    return {polygon_gradient - energy.gradient,
            polygon_gradient + energy.gradient,
            energy.segment_area};
}

// Adds a part of the gradient to a row and the next row. Does nothing if the row is negative, which
// means that the unknown is held.
void add(Eigen::VectorXd& r, int row, const Vec2& part) {
    if (row >= 0) {
        r.segment<2>(row) += part;
    }
}

// Adds a part of the gradient to a row. Does nothing if the row is negative.
void add(Eigen::VectorXd& r, int row, double part) {
    if (row >= 0) {
        r[row] += part;
    }
}

void add_part(const Network& network,
              const Unknowns& unknowns,
              FilmId film,
              const FilmGradient& gradient,
              Eigen::VectorXd& r) {
    const HalfEdgeId h = forward_side(film);
    add(r, unknowns.position_row(network.tail(h)), gradient.tail);
    add(r, unknowns.position_row(network.head(h)), gradient.head);
    add(r, unknowns.pressure_row(network.left(h)), -gradient.right);
    add(r, unknowns.pressure_row(network.right(h)), gradient.right);
    if (network.is_outer(film)) {
        r[unknowns.angle_row(film)] = gradient.angle;
    }
}

}  // namespace

Eigen::VectorXd residual(const Foam& foam, const Unknowns& unknowns, int threads) {
    Eigen::VectorXd r = Eigen::VectorXd::Zero(unknowns.size());
    auto areas = r.segment(unknowns.first_pressure_row(),
                           static_cast<Eigen::Index>(unknowns.bubbles.size()));
    for_each_index(unknowns.bubbles.size(), threads, [&](std::size_t k) {
        const BubbleId bubble = unknowns.bubbles[k];
        areas[static_cast<Eigen::Index>(k)] =
            foam.target_areas[bubble] - polygon_area(foam, bubble);
    });
    std::vector<FilmGradient> gradients(unknowns.films.size());
    for_each_index(gradients.size(), threads, [&](std::size_t k) {
        gradients[k] = film_gradient(foam, unknowns.films[k]);
    });
    for (std::size_t k = 0; k < gradients.size(); ++k) {
        add_part(foam.network, unknowns, unknowns.films[k], gradients[k], r);
    }
    return r;
}

ResidualNorms norms(const Foam& foam, const Unknowns& unknowns, const Eigen::VectorXd& residual) {
    ResidualNorms norms;
    const auto rows = static_cast<Eigen::Index>(2 * unknowns.junctions.size());
    for (Eigen::Index row = 0; row < rows; row += 2) {
        const double force = residual.segment<2>(row).norm() / foam.film_tension;
        norms.force = max_or_nan(norms.force, force);
        norms.squares += force * force;
    }
    for (std::size_t k = 0; k < unknowns.bubbles.size(); ++k) {
        const double error =
            residual[rows + static_cast<Eigen::Index>(k)] / foam.target_areas[unknowns.bubbles[k]];
        norms.area = max_or_nan(norms.area, std::abs(error));
        norms.squares += error * error;
    }
    for (const FilmId film : unknowns.outer_films) {
        const HalfEdgeId h = forward_side(film);
        const double error =
            laplace_young_error(film_arc(foam, h), pressure_difference(foam, h), foam.film_tension);
        norms.force = max_or_nan(norms.force, std::abs(error));
        norms.squares += error * error;
    }
    return norms;
}

}  // namespace foam
