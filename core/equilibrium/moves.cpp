#include "core/equilibrium/moves.h"

#include "core/equilibrium/t1_rule.h"
#include "core/network/t1.h"

#include <algorithm>
#include <cmath>

namespace foam {

namespace {

Vec2 move_of(const Unknowns& unknowns, const Eigen::VectorXd& step, JunctionId junction) {
    return step.segment<2>(unknowns.position_row(junction));
}

// Whether the whole step would shorten the film by more than half, and its flipped state stays
// open.
bool awaits_flip(const Foam& foam,
                 const Unknowns& unknowns,
                 const Eigen::VectorXd& step,
                 FilmId film) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 d = chord(foam, h);
    const Vec2 growth = move_of(unknowns, step, foam.network.head(h)) -
                        move_of(unknowns, step, foam.network.tail(h));
    return growth.dot(d) < -0.5 * d.squaredNorm() && can_flip(foam.network, film) &&
           flipped_pulls_apart(foam, film, Tangents::OfArcs);
}

}  // namespace

double allowed_share(const Vec2& chord, const Vec2& change, double largest) {
    const double c = chord.norm();
    if (c == 0.0) {
        return 1.0;
    }
    const double along = change.dot(chord) / c;
    const double across = std::abs(cross(chord, change)) / c;
    const double shrinking = along < 0.0 ? largest * c / -along : 1.0;
    const double room = largest * (c + std::max(along, 0.0));
    const double turning = across > room ? room / across : 1.0;
    return std::min({1.0, shrinking, turning});
}

State state_of(const Foam& foam, const Unknowns& unknowns) {
    State state;
    for (const JunctionId junction : unknowns.junctions) {
        state.positions.push_back(foam.positions[junction]);
    }
    for (const BubbleId bubble : unknowns.bubbles) {
        state.pressures.push_back(foam.pressures[bubble]);
    }
    return state;
}

void set_state(Foam& foam,
               const Unknowns& unknowns,
               const State& state,
               const Eigen::VectorXd& step,
               double fraction) {
    Eigen::Index row = 0;
    for (std::size_t k = 0; k < state.positions.size(); ++k, row += 2) {
        foam.positions[unknowns.junctions[k]] =
            state.positions[k] + fraction * step.segment<2>(row);
    }
    for (std::size_t k = 0; k < state.pressures.size(); ++k, ++row) {
        foam.pressures[unknowns.bubbles[k]] = state.pressures[k] + fraction * step[row];
    }
}

void wrap(Foam& foam, const Unknowns& unknowns) {
    for (const JunctionId junction : unknowns.junctions) {
        place_junction(foam, junction, foam.positions[junction]);
    }
}

void limit_moves(const Foam& foam,
                 const Unknowns& unknowns,
                 double largest,
                 Eigen::VectorXd& step) {
    for (int sweep = 0; sweep < 4; ++sweep) {
        for (const FilmId film : unknowns.films) {
            const HalfEdgeId h = forward_side(film);
            const Vec2 d = chord(foam, h);
            const int tail = unknowns.position_row(foam.network.tail(h));
            const int head = unknowns.position_row(foam.network.head(h));
            const Vec2 growth = move_of(unknowns, step, foam.network.head(h)) -
                                move_of(unknowns, step, foam.network.tail(h));
            const double share = allowed_share(d, growth, largest);
            if (share >= 1.0 || tail == head) {
                continue;
            }
            step.segment<2>(tail) += 0.5 * (1.0 - share) * growth;
            step.segment<2>(head) -= 0.5 * (1.0 - share) * growth;
        }
    }
}

std::vector<FilmId> collapsing_films(const Foam& foam,
                                     const Unknowns& unknowns,
                                     const Eigen::VectorXd& step,
                                     const TopologyThresholds& thresholds) {
    std::vector<FilmId> films;
    for (const FilmId film : unknowns.films) {
        const double length = chord(foam, forward_side(film)).norm();
        if (length < thresholds.t1_distance && (length < collapsed_length(foam, film, thresholds) ||
                                                (length < t1_length(foam, film, thresholds) &&
                                                 awaits_flip(foam, unknowns, step, film)))) {
            films.push_back(film);
        }
    }
    return films;
}

}  // namespace foam
