#include "core/equilibrium/residual.h"

#include "core/foam/measure.h"
#include "core/geometry/film_energy.h"

#include <algorithm>
#include <cmath>

namespace foam {

namespace {

void add_film(const Foam& foam, const Unknowns& unknowns, FilmId film, Eigen::VectorXd& r) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 d = chord(foam, h);
    const double delta = pressure_difference(foam, h);
    const FilmEnergy energy = film_energy(d, delta, foam.film_tension);
    const Vec2 push = 0.5 * delta * turned_left(d);  // -delta P(d) / 2, half at each end (E3)
    r.segment<2>(unknowns.position_row(foam.network.tail(h))) += push - energy.gradient;
    r.segment<2>(unknowns.position_row(foam.network.head(h))) += push + energy.gradient;
    r[unknowns.pressure_row(foam.network.left(h))] -= energy.segment_area;
    r[unknowns.pressure_row(foam.network.right(h))] += energy.segment_area;
}

}  // namespace

double lagrangian(const Foam& foam) {
    double sum = 0.0;
    for (const FilmId film : foam.network.films()) {
        const HalfEdgeId h = forward_side(film);
        sum += film_energy(chord(foam, h), pressure_difference(foam, h), foam.film_tension).value;
    }
    for (const BubbleId bubble : foam.network.bubbles()) {
        sum -= foam.pressures[bubble] * (polygon_area(foam, bubble) - foam.target_areas[bubble]);
    }
    return sum;
}

Eigen::VectorXd residual(const Foam& foam, const Unknowns& unknowns) {
    Eigen::VectorXd r = Eigen::VectorXd::Zero(unknowns.size());
    for (const BubbleId bubble : unknowns.bubbles) {
        r[unknowns.pressure_row(bubble)] = foam.target_areas[bubble] - polygon_area(foam, bubble);
    }
    for (const FilmId film : unknowns.films) {
        add_film(foam, unknowns, film, r);
    }
    return r;
}

ResidualNorms norms(const Foam& foam, const Unknowns& unknowns, const Eigen::VectorXd& residual) {
    ResidualNorms norms;
    const auto rows = static_cast<Eigen::Index>(2 * unknowns.junctions.size());
    for (Eigen::Index row = 0; row < rows; row += 2) {
        const double force = residual.segment<2>(row).norm() / foam.film_tension;
        norms.force = std::max(norms.force, force);
        norms.squares += force * force;
    }
    for (std::size_t k = 0; k < unknowns.bubbles.size(); ++k) {
        const double error =
            residual[rows + static_cast<Eigen::Index>(k)] / foam.target_areas[unknowns.bubbles[k]];
        norms.area = std::max(norms.area, std::abs(error));
        norms.squares += error * error;
    }
    return norms;
}

}  // namespace foam
