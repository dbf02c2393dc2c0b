// SPDX-License-Identifier: Apache-2.0

#include "core/equilibrium/moves.h"

#include "core/foam/t1_rule.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foam {

// Newton's method is globalized by limiting relative motion. The ends of a film may approach each
// other, or rotate around each other, only by a fraction of its chord length. Their common motion
// is free. A limit on the motion of each junction would also stop the common motion of short films.
// Moreover, a step that is limited in this way would not be a descent direction (NOTES.md).

namespace {

constexpr int kLimitSweeps = 4;  // largest number of sweeps over the films in limit_moves

Vec2 move_of(const Unknowns& unknowns, const Eigen::VectorXd& step, JunctionId junction) {
    const int row = unknowns.position_row(junction);
    return row < 0 ? Vec2(0.0, 0.0) : Vec2(step.segment<2>(row));
}

// Returns true if three conditions are met:
// - the whole step would make the film shorter than `length`;
// - the film can flip or tear;
// - by the forces before the step, it would stay open after the flip or tear (would_stay_open).
bool would_flip_after_step(const Foam& foam,
                           const Unknowns& unknowns,
                           const Eigen::VectorXd& step,
                           FilmId film,
                           double length) {
    const HalfEdgeId h = forward_side(film);
    const Vec2 new_chord = chord(foam, h) + move_of(unknowns, step, foam.network.head(h)) -
                           move_of(unknowns, step, foam.network.tail(h));
    return new_chord.norm() < length && can_change(foam.network, film) &&
           would_stay_open(foam, film);
}

// Returns the films that have collapsed, and the films below their T1 distance for which
// is_due(film, length) returns true.
template <class IsDue>
std::vector<FilmId> films_for_t1(const Foam& foam,
                                 const Unknowns& unknowns,
                                 const TopologyThresholds& thresholds,
                                 const IsDue& is_due) {
    const double longest = thresholds.t1_distance;
    std::vector<FilmId> films;
    for (const FilmId film : unknowns.films) {
        const double squared_length = chord(foam, forward_side(film)).squaredNorm();
        if (squared_length >= longest * longest) {
            continue;
        }
        const double length = std::sqrt(squared_length);
        if (length < collapsed_length(foam, film, thresholds) ||
            (length < t1_distance_at(foam, film, thresholds) && is_due(film, length))) {
            films.push_back(film);
        }
    }
    return films;
}

void add_move(const Unknowns& unknowns,
              Eigen::VectorXd& step,
              JunctionId junction,
              const Vec2& move) {
    const int row = unknowns.position_row(junction);
    if (row >= 0) {
        step.segment<2>(row) += move;
    }
}

// Reduces the relative motion of the film's ends to its allowed fraction. Each end makes half of
// the reduction, or all of it if the other end is held (its position is not an unknown). Returns
// true if the step was changed.
bool limit_film(const Foam& foam,
                const Unknowns& unknowns,
                FilmId film,
                double largest,
                Eigen::VectorXd& step) {
    const HalfEdgeId h = forward_side(film);
    const JunctionId tail = foam.network.tail(h);
    const JunctionId head = foam.network.head(h);
    const Vec2 growth = move_of(unknowns, step, head) - move_of(unknowns, step, tail);
    const Vec2 d = chord(foam, h);
    if (growth.squaredNorm() <= largest * largest * d.squaredNorm()) {
        return false;
    }
    const double fraction = allowed_fraction(d, growth, largest);
    if (fraction >= 1.0 || tail == head) {
        return false;
    }
    const bool both_free = unknowns.position_row(tail) >= 0 && unknowns.position_row(head) >= 0;
    const Vec2 cut = (both_free ? 0.5 : 1.0) * (1.0 - fraction) * growth;
    add_move(unknowns, step, tail, cut);
    add_move(unknowns, step, head, -cut);
    return true;
}

bool limit_half_angle(const Foam& foam,
                      const Unknowns& unknowns,
                      FilmId film,
                      double largest,
                      Eigen::VectorXd& step) {
    double& change = step[unknowns.angle_row(film)];
    const double angle = foam.half_angles[film];
    const double margin = std::numbers::pi - std::copysign(angle, angle * change);
    const double limit = largest * std::min(1.0, margin);
    const bool changed = std::abs(change) > limit;
    change = std::clamp(change, -limit, limit);
    return changed;
}

}  // namespace

double allowed_fraction(const Vec2& chord, const Vec2& change, double largest) {
    const double c = chord.norm();
    if (c == 0.0) {
        return 1.0;
    }
    const double along = change.dot(chord) / c;
    const double across = std::abs(cross(chord, change)) / c;
    const double shrinking = along < 0.0 ? largest * c / -along : 1.0;
    const double limit = largest * (c + std::max(along, 0.0));
    const double turning = across > limit ? limit / across : 1.0;
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
    for (const FilmId film : unknowns.outer_films) {
        state.half_angles.push_back(foam.half_angles[film]);
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
    for (std::size_t k = 0; k < state.half_angles.size(); ++k, ++row) {
        const double angle = state.half_angles[k] + fraction * step[row];
        set_half_angle(foam, forward_side(unknowns.outer_films[k]), angle);
    }
}

void wrap(Foam& foam, const Unknowns& unknowns) {
    for (const JunctionId junction : unknowns.junctions) {
        place_junction(foam, junction, foam.positions[junction]);
    }
}

bool limit_moves(const Foam& foam,
                 const Unknowns& unknowns,
                 double largest,
                 Eigen::VectorXd& step) {
    bool changed = false;
    for (const FilmId film : unknowns.outer_films) {
        changed = limit_half_angle(foam, unknowns, film, largest, step) || changed;
    }
    for (int sweep = 0; sweep < kLimitSweeps; ++sweep) {
        bool changed_now = false;
        for (const FilmId film : unknowns.films) {
            changed_now = limit_film(foam, unknowns, film, largest, step) || changed_now;
        }
        if (!changed_now) {
            break;
        }
        changed = true;
    }
    return changed;
}

std::vector<FilmId> collapsing_films(const Foam& foam,
                                     const Unknowns& unknowns,
                                     const Eigen::VectorXd& step,
                                     const TopologyThresholds& thresholds) {
    return films_for_t1(foam, unknowns, thresholds, [&](FilmId film, double length) {
        return would_flip_after_step(foam, unknowns, step, film, 0.5 * length);
    });
}

std::vector<FilmId> films_staying_short(const Foam& foam,
                                        const Unknowns& unknowns,
                                        const Eigen::VectorXd& step,
                                        const TopologyThresholds& thresholds) {
    return films_for_t1(foam, unknowns, thresholds, [&](FilmId film, double) {
        return would_flip_after_step(
            foam, unknowns, step, film, t1_distance_at(foam, film, thresholds));
    });
}

}  // namespace foam
